// Counts how often words that are no tags are taken for one, by family, level and corrected bits:
// random words beside the formula, and what the detector reads in pictures without tags.
//
//   false_accepts [--words N] [--safe-words N] [--seed N] [--threads N] [--family F]... [--csv DIR]
//                 [FOLDER...]
//
// Without --family: all bundled families. Without FOLDER: no pictures; tools/fetch_photographs.sh
// gets some. Tables as markdown go to stdout, with --csv also to DIR.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "false_accepts/measured_codes.h"
#include "false_accepts/photograph_quads.h"
#include "false_accepts/random_words.h"
#include "tagmint/codec/builtin_families.h"

namespace tagmint::bench {
namespace {

struct Arguments {
  RandomWordsPlan words{.words_at_two = 100'000'000, .words_at_safe = 1'000'000};
  std::vector<std::string> families;
  std::vector<std::string> folders;
  std::string csv;
};

Arguments parse(const std::vector<std::string>& words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!words[i].starts_with("--")) {
      arguments.folders.push_back(words[i]);
      continue;
    }
    const std::string& option = words[i];
    if (++i == words.size()) throw std::invalid_argument(option + " needs a value");
    const std::string& value = words[i];
    if (option == "--family") {
      arguments.families.push_back(value);
    } else if (option == "--csv") {
      arguments.csv = value;
    } else if (option == "--words") {
      arguments.words.words_at_two = static_cast<std::uint64_t>(std::stod(value));
    } else if (option == "--safe-words") {
      arguments.words.words_at_safe = static_cast<std::uint64_t>(std::stod(value));
    } else if (option == "--seed") {
      arguments.words.seed = std::stoull(value);
    } else if (option == "--threads") {
      arguments.words.threads = std::stoi(value);
    } else {
      throw std::invalid_argument("unknown option " + option);
    }
  }
  if (arguments.families.empty()) {
    const auto names = codec::family_names();
    arguments.families.assign(names.begin(), names.end());
  }
  return arguments;
}

void write_csv(const std::string& folder, const std::string& name, const Table& table) {
  if (folder.empty()) return;
  std::ofstream stream(folder + "/" + name + ".csv");
  stream << as_csv(table);
  if (!stream.flush()) throw std::runtime_error("cannot write to " + folder);
}

void run(const Arguments& arguments) {
  const std::vector<MeasuredCode> codes = measured_codes(arguments.families);
  if (arguments.words.words_at_two > 0) {
    const std::vector<RandomWords> counts = count_random_words(codes, arguments.words);
    fmt::print("{}\n{}\n\n", as_markdown(random_words_table(counts, codes)),
               agreement(counts, codes));
    std::fflush(stdout);
    write_csv(arguments.csv, "random_words", random_words_by_errors(counts, codes));
  }
  if (arguments.folders.empty()) return;
  const std::vector<std::string> files = find_pictures(arguments.folders);
  const PhotographCounts counts = decode_photographs(files, codes, arguments.words.threads);
  fmt::print("{} pictures, {} images of {:.0f} Mpx in all\n\n", counts.pictures, counts.images,
             counts.megapixels);
  if (counts.pictures == 0) return;
  fmt::print("{}\n", as_markdown(photographs_table(counts, codes)));
  write_csv(arguments.csv, "photographs", photographs_by_errors(counts, codes));
}

}  // namespace
}  // namespace tagmint::bench

int main(int count, char** words) {
  try {
    tagmint::bench::run(tagmint::bench::parse(std::vector<std::string>(words + 1, words + count)));
    return 0;
  } catch (const std::exception& fault) {
    fmt::print(stderr, "false_accepts: {}\n", fault.what());
    return 1;
  }
}
