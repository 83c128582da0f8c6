#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "evaluate/experiment.h"

namespace tagmint::evaluate {

/// Columns "contender" and "decimate", which most tables have.
Column contender_column();
Column decimate_column();

/// Curves of a table, one for each contender: spots (x, y) of its rows.
///   where   which rows count
std::vector<plot::Series> curves(const Table& table, const Settings& settings, std::string_view x,
                                 std::string_view y,
                                 const std::function<bool(const Row&)>& where = {});

/// Rows of one decimation.
std::function<bool(const Row&)> decimated_by(const Table& table, double decimate);

/// One panel at full resolution and one decimated by 2, alike in all else.
std::vector<plot::Panel> at_both_sizes(const Table& table, const Settings& settings,
                                       const plot::Axis& x, const plot::Axis& y,
                                       std::string_view x_column, std::string_view y_column);

/// "12 of 14"; for lines of a summary.
std::string aligned(const std::vector<std::vector<std::string>>& rows);

/// Who takes part, for the head of a CSV file and the note of a figure.
std::string contestants(const Settings& settings);
std::string family_words(const codec::Family& family);

/// samples, else quick or full.
int samples_of(const Settings& settings, int quick, int full);

}  // namespace tagmint::evaluate
