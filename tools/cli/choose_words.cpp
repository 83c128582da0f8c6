// The sentences and commands that the text and the JSON of `tagmint choose` share.
#include <fmt/format.h>

#include <cmath>

#include "cli/choose_report.h"
#include "draw/units.h"

namespace tagmint::cli {
namespace {

/// "43,800": three digits and groups of three.
std::string rounded_count(double count) {
  const double unit = std::pow(10.0, std::max(0.0, std::floor(std::log10(count)) - 2));
  std::string digits = fmt::format("{:.0f}", std::round(count / unit) * unit);
  for (std::ptrdiff_t at = std::ssize(digits) - 3; at > 0; at -= 3) {
    digits.insert(static_cast<std::size_t>(at), 1, ',');
  }
  return digits;
}

}  // namespace

std::string one_in_text(double share) {
  const double count = 1 / share;
  return count < 1e9 ? "1 in " + rounded_count(count) : fmt::format("1 in {:.1e}", count);
}

std::string caution_text(Caution caution, const FamilyChoice& choice) {
  switch (caution) {
    case Caution::BeyondRange:
      return fmt::format("cells of {:.2f} px are too small: {:.0f} % of the tags are read",
                         choice.cell_px, 100 * choice.found);
    case Caution::LittleReserve:
      return fmt::format(
          "little reserve: face to face the range is {:.2f} m, less with tilt or blur",
          choice.range_mm / 1000);
    case Caution::ManyFalseAccepts:
      return fmt::format(
          "many false accepts: {} random words passes for a tag even without correction",
          one_in_text(choice.accepted));
    case Caution::PlainTags:
      return fmt::format("{} of the ids fail the complexity rule: texture imitates them more often",
                         choice.plain_ids);
    case Caution::Hole:
      return "the middle of the tag is a hole";
    case Caution::CustomLayout:
      return "custom layout: make sure that every program which is to read it takes one";
    case Caution::LargeIds:
      return fmt::format("ids go up to {}: libapriltag holds {} tags, convert cuts the rest off",
                         choice.ids.back().last, kMostForeignTags);
  }
  return {};
}

std::string print_command(const FamilyChoice& choice, const TagUse& use) {
  return fmt::format("tagmint sheet {} {} {} --ids {} -o tags.pdf", choice.source,
                     use.outer ? "--outer" : "--edge", draw::format_mm(use.size_mm, ""),
                     id_list_text(choice.ids));
}

std::string find_command(const FamilyChoice& choice) {
  return fmt::format("tagmint detect --family {} --ids {} --max-hamming {} IMAGE...", choice.source,
                     id_list_text(choice.ids), choice.max_hamming);
}

}  // namespace tagmint::cli
