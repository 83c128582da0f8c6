#pragma once

#include <span>
#include <string>

#include "detector/measure.h"

namespace tagmint::bench {

/// One set as a markdown table with its title.
std::string as_markdown(const PictureSet& set, std::span<const Row> rows);

/// The head of the CSV file, and lines for rows; lengths px, times ns a pixel.
std::string csv_head();
std::string as_csv(std::span<const Row> rows);

}  // namespace tagmint::bench
