#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "cli/choose_report.h"
#include "cli/text_table.h"
#include "draw/units.h"

namespace tagmint::cli {
namespace {

/// What the letters of the last column mean, in the order of Caution.
struct Note {
  char letter;
  const char* meaning;
};
constexpr std::array<Note, kCautions> kNotes = {{
    {'a', "out of range"},
    {'b', "little reserve: in range face to face, perhaps not with tilt or blur"},
    {'c', "many false accepts, even without correction"},
    {'d', "some of the ids fail the complexity rule"},
    {'e', "the middle of the tag is a hole"},
    {'f', "custom layout"},
    {'g', "ids that libapriltag cannot hold"},
}};

const Note& note_of(Caution caution) { return kNotes[static_cast<std::size_t>(caution)]; }

std::string metres(double length_mm) { return fmt::format("{:.2f} m", length_mm / 1000); }

std::string letters_of(const FamilyChoice& choice) {
  std::string letters;
  for (const Caution caution : choice.cautions) letters += note_of(caution).letter;
  return letters;
}

std::string readers_text(const FamilyChoice& choice) {
  if (choice.read_by.empty()) return "-";
  const std::string programs = fmt::format("{}", fmt::join(choice.read_by, ", "));
  if (choice.known_as == choice.family->name()) return programs;
  return fmt::format("{} (as {})", programs, choice.known_as);
}

/// The level's part of a family's name: "" where the family is one level.
std::string level_text(const FamilyChoice& choice) {
  const auto levels = choice.family->levels();
  const codec::Level& level = levels[choice.level];
  return levels.size() == 1
             ? fmt::format("all {} tags, distance {}", level.codes, level.min_hamming)
             : fmt::format("level {} of {}: {} tags at distance {}", choice.level + 1,
                           levels.size(), level.codes, level.min_hamming);
}

std::string recommendation(const FamilyChoice& choice, const TagUse& use) {
  std::string text = fmt::format("{}, ids {} ({}): corrects {} bits, read up to {}\n",
                                 choice.family->name(), id_list_text(choice.ids),
                                 level_text(choice), choice.max_hamming, metres(choice.range_mm));
  text += fmt::format("  print  {}\n", print_command(choice, use));
  text += fmt::format("  find   {}\n", find_command(choice));
  for (const Caution caution : choice.cautions) {
    text += fmt::format("  note   {}\n", caution_text(caution, choice));
  }
  return text;
}

std::vector<std::string> row_of(std::size_t place, const FamilyChoice& choice) {
  const codec::Level& level = choice.family->levels()[choice.level];
  return {fmt::to_string(place),
          choice.family->name(),
          fmt::to_string(level.codes),
          fmt::to_string(choice.min_hamming),
          fmt::to_string(choice.safe_errors),
          fmt::to_string(choice.max_hamming),
          fmt::format("{:.2f}", choice.cell_px),
          fmt::format("{:.0f} %", 100 * choice.found),
          metres(choice.range_mm),
          fmt::format("{:.0f} mm", choice.with_quiet_zone_mm),
          fmt::format("{:.1e}", choice.accepted),
          fmt::format("{:.1e}", choice.accepted_at_2),
          fmt::format("{:.1e}", choice.accepted_at_safe),
          readers_text(choice),
          letters_of(choice)};
}

std::string table_of(const ChoosePlan& plan) {
  std::vector<std::vector<std::string>> rows = {
      {"", "family", "tags", "distance", "safe", "correct", "px/cell", "read", "range", "size",
       "accepts", "at 2", "at safe", "other programs", "notes"}};
  for (std::size_t i = 0; i < plan.ranked.size(); ++i) {
    rows.push_back(row_of(i + 1, plan.ranked[i]));
  }
  std::vector<Align> align(rows.front().size(), Align::Right);
  align[1] = Align::Left;
  align[align.size() - 2] = Align::Left;
  align.back() = Align::Left;
  return format_table(align, rows);
}

std::string notes_of(const ChoosePlan& plan) {
  std::array<bool, kCautions> used{};
  for (const FamilyChoice& choice : plan.ranked) {
    for (const Caution caution : choice.cautions) used[static_cast<std::size_t>(caution)] = true;
  }
  std::string text;
  for (std::size_t i = 0; i < kNotes.size(); ++i) {
    if (used[i]) text += fmt::format("  {}  {}\n", kNotes[i].letter, kNotes[i].meaning);
  }
  return text;
}

std::string left_out(const ChoosePlan& plan) {
  std::string text;
  for (const TooSmall& family : plan.too_small) {
    text +=
        fmt::format("{}{} ({})", text.empty() ? "too few tags: " : ", ", family.name, family.tags);
  }
  return text.empty() ? text : text + "\n";
}

}  // namespace

std::string choose_text(const ChoosePlan& plan, const TagUse& use) {
  std::string text;
  if (plan.ranked.empty()) {
    text = fmt::format("no family has {} tags\n", use.tags);
  } else {
    text = recommendation(plan.ranked.front(), use) + "\n" + table_of(plan);
    const std::string notes = notes_of(plan);
    if (!notes.empty()) text += "\n" + notes;
  }
  const std::string missing = left_out(plan);
  return missing.empty() ? text : text + "\n" + missing;
}

}  // namespace tagmint::cli
