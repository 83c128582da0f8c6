#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cli/command.h"

namespace tagmint::cli {

/// The options of `tagmint sheet` as they were typed; empty or zero where they were not.
struct SheetArguments {
  std::vector<std::string> tags;
  std::string ids;
  std::string edge;
  std::string outer;
  double quiet_zone_cells = 1.0;
  std::string label;
  std::string paper = "a4";
  bool landscape = false;
  std::string margin;
  std::string gap = "5mm";
  int columns = 0;
  int rows = 0;
  std::string title;
  bool ruler = false;
  bool no_ruler = false;
  bool cut_marks = false;
  std::string cut_lines;  ///< their shape
  std::string color;
  std::string ground;
  bool invert = false;
  bool outline = false;
  double dpi = 300.0;
  bool exact = false;
  std::string depth = "8";
  std::string format;
  std::string output;
  bool verify = false;
  bool dry_run = false;
  std::vector<std::string> given;  ///< names of those options that were, like "--paper"

  bool is_given(const std::string& name) const;
};

inline constexpr const char* kDefaultSheetLabel = "{family}  {id}";
inline constexpr const char* kDefaultSheetMargin = "10mm";

/// Adds the options; returns a function that notes in `given` which were, to be called after the
/// command line was parsed.
std::function<void()> add_sheet_options(CLI::App& app, std::shared_ptr<SheetArguments> arguments);

}  // namespace tagmint::cli
