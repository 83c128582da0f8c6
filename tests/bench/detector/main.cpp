// The detector beside its peers, in one run: recall, false ids, corner errors and time on sets of
// pictures, as markdown on stdout and with -o as CSV. --help lists the options.
#include <fmt/format.h>
#include <hwy/targets.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "detector/measure.h"
#include "detector/table.h"
#include "io/images.h"

namespace tagmint::bench {
namespace {

struct Arguments {
  MeasureOptions measure;
  PictureSize size;
  std::vector<std::string> sets;        ///< names or groups; empty = all
  std::vector<std::string> contenders;  ///< beginnings of names; empty = all
  std::string photographs;
  std::string labelled;
  std::string instructions;
  std::string csv;
  std::string save;
  bool processor_time = false;
  bool quick = false;
  bool list = false;
};

void add_options(CLI::App& app, Arguments& a) {
  app.add_option("--sets", a.sets, "sets or groups of sets, by name (--list shows them)")
      ->delimiter(',');
  app.add_option("--contenders", a.contenders, "those whose names begin so; libapriltag for ratios")
      ->delimiter(',');
  app.add_option("--pictures", a.measure.pictures, "of each set")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  app.add_option("--repetitions", a.measure.repetitions, "timed passes; medians count")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--seed", a.measure.seed, "other pictures")->capture_default_str();
  app.add_option("--width", a.size.width, "of rendered pictures, px")
      ->check(CLI::Range(64, 16384))
      ->capture_default_str();
  app.add_option("--height", a.size.height, "of rendered pictures, px")
      ->check(CLI::Range(64, 16384))
      ->capture_default_str();
  app.add_option("--photographs", a.photographs, "a folder of pictures without tags");
  app.add_option("--labelled", a.labelled, "a folder of pictures and labels.json");
  app.add_option("--instructions", a.instructions,
                 "the one instruction set that vector code may use, like AVX2 or SSE4");
  app.add_flag("--processor-time", a.processor_time,
               "count the processor's time, not the wall clock's: for a busy machine");
  app.add_option("-o", a.csv, "write all rows to a CSV file");
  app.add_option("--save", a.save, "draw only: the sets' first pictures as PNG into this folder");
  app.add_flag("--quick", a.quick, "about a minute: one picture a set, every third of a group");
  app.add_flag("--list", a.list, "name the sets and stop");
}

/// Leaves vector code one instruction set, in this library and all others that use Highway.
void choose_instructions(const std::string& name) {
  if (name.empty()) return;
  std::string known;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    if (name == hwy::TargetName(target)) {
      hwy::SetSupportedTargetsForTest(target);
      hwy::GetChosenTarget().Update(hwy::SupportedTargets());
      return;
    }
    known += std::string(known.empty() ? "" : ", ") + hwy::TargetName(target);
  }
  throw std::invalid_argument("instruction set " + name + " is not here; there are " + known);
}

std::vector<PictureSet> wanted_sets(const Arguments& a) {
  std::vector<PictureSet> all = rendered_sets(a.size);
  if (!a.photographs.empty()) {
    for (PictureSet& set : photograph_sets(a.photographs, a.size)) all.push_back(std::move(set));
  }
  if (!a.labelled.empty()) all.push_back(labelled_set(a.labelled));
  for (const std::string& name : a.sets) {
    if (std::none_of(all.begin(), all.end(), [&](const PictureSet& set) {
          return name == set.name || name == set.group();
        })) {
      throw std::invalid_argument("there is no set " + name + "; --list names them");
    }
  }
  std::erase_if(all, [&](const PictureSet& set) {
    return !a.sets.empty() && std::none_of(a.sets.begin(), a.sets.end(), [&](const auto& name) {
      return name == set.name || name == set.group();
    });
  });
  return all;
}

/// One of three sets of each group, its last one among them.
void thin_out(std::vector<PictureSet>& sets) {
  constexpr std::size_t kStep = 3;
  std::vector<PictureSet> kept;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    std::size_t after = 0;
    while (i + after + 1 < sets.size() && sets[i + after + 1].group() == sets[i].group()) ++after;
    if (after % kStep == 0) kept.push_back(sets[i]);
  }
  sets = std::move(kept);
}

std::vector<ContenderKind> wanted_contenders(const Arguments& a) {
  std::vector<ContenderKind> kinds = all_contenders();
  std::erase_if(kinds, [&](const ContenderKind& kind) {
    return !a.contenders.empty() &&
           std::none_of(a.contenders.begin(), a.contenders.end(),
                        [&](const auto& begin) { return kind.name.starts_with(begin); });
  });
  if (kinds.empty()) throw std::invalid_argument("no contender has such a name");
  return kinds;
}

void run(Arguments a) {
  choose_instructions(a.instructions);
  std::vector<PictureSet> sets = wanted_sets(a);
  if (a.processor_time) a.measure.time = TimeKind::Processor;
  if (a.quick) {
    a.measure.pictures = 1;
    a.measure.repetitions = 3;
    thin_out(sets);
    for (PictureSet& set : sets) set.whole = false;
  }
  if (a.list) {
    for (const PictureSet& set : sets) fmt::print("{:<16} {}\n", set.name, set.about);
    return;
  }
  if (!a.save.empty()) {
    for (const PictureSet& set : sets) {
      io::write_png(a.save + "/" + set.name + ".png", set.draw(0, a.measure.seed).image.view());
    }
    return;
  }
  const std::vector<ContenderKind> kinds = wanted_contenders(a);
  std::string csv = csv_head();
  for (const PictureSet& set : sets) {
    const std::vector<Row> rows = measure(set, kinds, a.measure);
    fmt::print("{}\n", as_markdown(set, rows));
    std::fflush(stdout);
    csv += as_csv(rows);
  }
  if (a.csv.empty()) return;
  std::ofstream stream(a.csv);
  stream << csv;
  if (!stream.flush()) throw std::runtime_error("cannot write to " + a.csv);
}

}  // namespace
}  // namespace tagmint::bench

int main(int count, char** words) {
  CLI::App app("The detector beside its peers on sets of pictures, as tables");
  tagmint::bench::Arguments arguments;
  tagmint::bench::add_options(app, arguments);
  CLI11_PARSE(app, count, words);
  try {
    tagmint::bench::run(arguments);
  } catch (const std::exception& fault) {
    fmt::print(stderr, "detector_bench: error: {}\n", fault.what());
    return 2;
  }
}
