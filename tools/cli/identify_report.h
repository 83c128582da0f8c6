#pragma once

#include <string>

#include "identify/identify.h"

namespace tagmint::cli {

/// A picture and what it shows.
struct IdentifyReport {
  std::string image;  ///< as it was named on the command line
  int width = 0;      ///< px
  int height = 0;     ///< px
  identify::Identification found;
};

/// Some lines for people.
std::string identify_text(const IdentifyReport& report);

/// One JSON object in the shape of docs/identify.md.
std::string identify_json(const IdentifyReport& report);

}  // namespace tagmint::cli
