#include "detector/table.h"

#include <fmt/format.h>

#include <iterator>

namespace tagmint::bench {
namespace {

/// The columns of accuracy; a set without tags, or of which none was found, has none.
std::string accuracy_cells(const Score& score) {
  if (score.found == 0) return "- | - | - | -";
  return fmt::format("{:.3f} px | {:.3f} px | {:+.4f} px | {:+.2f} %",
                     quantile(score.corner_errors_px, 0.5), quantile(score.corner_errors_px, 0.95),
                     trimmed_mean(score.radial_errors_px), 100 * trimmed_mean(score.size_errors));
}

}  // namespace

std::string as_markdown(const PictureSet& set, std::span<const Row> rows) {
  const int pictures = rows.empty() ? 0 : rows[0].pictures;
  const int tags = rows.empty() ? 0 : rows[0].score.tags;
  std::string text =
      fmt::format("**{}**: {} ({} pictures, {} tags)\n\n", set.name, set.about, pictures, tags);
  text +=
      "| | recall | false | corner error, median | 95 % | radial bias | size error | ns/px | times "
      "as fast |\n|---|---|---|---|---|---|---|---|---|\n";
  for (const Row& row : rows) {
    const std::string recall =
        row.score.tags > 0 ? fmt::format("{:.1f} %", 100 * row.score.recall()) : "-";
    const std::string ratio =
        row.times_as_fast > 0 ? fmt::format("{:.2f}", row.times_as_fast) : "-";
    fmt::format_to(std::back_inserter(text), "| {} | {} | {} | {} | {:.3f} | {} |\n", row.contender,
                   recall, row.score.false_ids, accuracy_cells(row.score),
                   row.nanoseconds_per_pixel, ratio);
  }
  return text;
}

std::string csv_head() {
  return "set,contender,pictures,tags,found,false_ids,corner_error_median_px,corner_error_95_px,"
         "radial_bias_px,size_error,ns_per_px,times_as_fast\n";
}

std::string as_csv(std::span<const Row> rows) {
  std::string text;
  for (const Row& row : rows) {
    const Score& s = row.score;
    fmt::format_to(std::back_inserter(text),
                   "{},\"{}\",{},{},{},{},{:.5f},{:.5f},{:.5f},{:.6f},{:.5f},{:.4f}\n", row.set,
                   row.contender, row.pictures, s.tags, s.found, s.false_ids,
                   quantile(s.corner_errors_px, 0.5), quantile(s.corner_errors_px, 0.95),
                   trimmed_mean(s.radial_errors_px), trimmed_mean(s.size_errors),
                   row.nanoseconds_per_pixel, row.times_as_fast);
  }
  return text;
}

}  // namespace tagmint::bench
