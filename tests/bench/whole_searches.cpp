// Whole searches for families, from the start of the program to its end, beside the plain scan of
// the same walks. Prints a table; fails when a search finds other codes than the bundled ones.
//
//   whole_searches [REPETITIONS [FAMILY ...]]
//
// All threads, medians of 5 repetitions unless told otherwise. Where a plain scan of the whole walk
// would take minutes to years, 2^25 words from its middle are scanned, with all codes of the family
// known, and the time is multiplied.

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <locale>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "search/engines.h"
#include "support/places.h"
#include "support/running_program.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family_file.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/search/lexicode.h"

namespace tagmint {
namespace {

struct Search {
  std::string family;  ///< bundled; its distance, rule and order are those of the search
  std::string layout;
  double published_s;    ///< as the authors printed it with their table
  bool published_whole;  ///< whether they searched to the end
};

const std::vector<Search> kSearches = {
    {"tag16h5", "classic:8", 0.3, true},
    {"tagCircle21h7", "circle:9", 0.9, true},
    {"tag25h9", "classic:9", 31, true},
    {"tag36h11", "classic:10", 210'508, true},
    {"tag36h10", "classic:10", 17'116, true},
    {"tag36h9x", "classic:10", 1'121'505, false},
    {"tagStandard41h12x", "standard:9", 44'384, false},
};

struct Seconds {
  double wall = 0;
  double processor = 0;
};

/// User and system time used so far by this process or by those that it has waited for.
double processor_seconds(int who) {
  rusage usage = {};
  getrusage(who, &usage);
  const auto seconds = [](const timeval& time) { return time.tv_sec + 1e-6 * time.tv_usec; };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

template <typename Work>
Seconds time_of(int who, const Work& work) {
  const double processor_before = processor_seconds(who);
  const auto start = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  return {wall.count(), processor_seconds(who) - processor_before};
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Seconds median(const std::vector<Seconds>& runs) {
  std::vector<double> wall;
  std::vector<double> processor;
  for (const Seconds& run : runs) {
    wall.push_back(run.wall);
    processor.push_back(run.processor);
  }
  return {median(wall), median(processor)};
}

/// One run of the program. Throws std::runtime_error when it finds other codes than `family`.
Seconds run_program(const Search& search, const codec::Family& family) {
  test::ProgramResult result;
  const Seconds time = time_of(RUSAGE_CHILDREN, [&] {
    result = test::run({test::program_path(), "generate", "--layout", search.layout,
                        "--min-hamming", std::to_string(family.min_hamming()), "--complexity",
                        codec::to_string(family.complexity()), "--order", family.origin().order,
                        "--output", "-"});
  });
  if (result.exit_code != 0) throw std::runtime_error(result.err);
  const codec::Family found = codec::parse_family(result.out, search.family);
  if (codec::family_digest(found) != codec::family_digest(family)) {
    throw std::runtime_error(
        fmt::format("{}: {} codes, other than bundled", search.family, found.size()));
  }
  return time;
}

/// Processor time that the plain scan of the whole walk takes.
double plain_scan_seconds(const codec::Family& family) {
  constexpr double kMostWords = 1 << 25;
  codec::LexicodeOptions options{.layout = family.layout(),
                                 .min_hamming = family.min_hamming(),
                                 .order = codec::parse_order(family.origin().order),
                                 .complexity = family.complexity()};
  const double walk = std::ldexp(1.0, family.bits());
  codec::SearchState start;
  double words = walk;
  if (walk > kMostWords) {
    words = kMostWords;
    start.words_walked = static_cast<std::uint64_t>(walk / 2);
    start.codewords.assign(family.codewords().begin(), family.codewords().end());
    start.walked_codes = family.size();
    options.limit_words = start.words_walked + static_cast<std::uint64_t>(words);
  }
  codec::LexicodeResult result;
  const Seconds time =
      time_of(RUSAGE_SELF, [&] { result = codec::search_plain(options, std::move(start)); });
  if (result.codewords.size() != family.size()) throw std::runtime_error("the scan finds others");
  return time.processor * (walk / words);
}

/// Thousands parted by commas.
struct Grouped : std::numpunct<char> {
  char do_thousands_sep() const override { return ','; }
  std::string do_grouping() const override { return "\3"; }
};

const std::locale& grouped() {
  static const std::locale locale(std::locale::classic(), new Grouped);
  return locale;
}

/// Three significant digits of a positive number.
std::string rounded(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 2);
  value = std::round(value / unit) * unit;
  return value < 100 ? fmt::format("{:.3g}", value) : fmt::format(grouped(), "{:.0Lf}", value);
}

/// Processor times are compared with the plain scan, as they suffer less from a busy machine; the
/// wall time is compared with the published one.
void print_row(const Search& search, const codec::Family& family, const Seconds& ours,
               double plain_s) {
  const char* at_least = search.published_whole ? "" : "> ";
  const std::string row = fmt::format(
      grouped(),
      "| {} | 2^{} | {:L} | {:.2f} s | {:.2f} s | {} ns | {} s | {} | {}{:L} s | {}{} |\n",
      search.family, family.bits(), family.size(), ours.wall, ours.processor,
      rounded(1e9 * std::ldexp(plain_s, -family.bits())), rounded(plain_s),
      rounded(plain_s / ours.processor), at_least, search.published_s, at_least,
      rounded(search.published_s / ours.wall));
  std::fputs(row.c_str(), stdout);
  std::fflush(stdout);
}

void measure(const Search& search, int repetitions) {
  const codec::SharedFamily family = codec::find_family(search.family);
  if (!family) throw std::runtime_error(search.family + " is not bundled");
  std::vector<Seconds> ours;
  std::vector<double> plain;
  for (int i = 0; i < repetitions; ++i) {
    ours.push_back(run_program(search, *family));
    plain.push_back(plain_scan_seconds(*family));
  }
  print_row(search, *family, median(ours), median(plain));
}

int measure_all(const std::vector<std::string>& arguments) {
  const int repetitions = arguments.empty() ? 5 : std::max(1, std::atoi(arguments[0].c_str()));
  fmt::print(
      "| family | words | codes | wall | processor | plain scan: a word | all words | ratio | "
      "published | ratio |\n|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Search& search : kSearches) {
    const bool wanted = arguments.size() < 2 || std::find(arguments.begin() + 1, arguments.end(),
                                                          search.family) != arguments.end();
    if (wanted) measure(search, repetitions);
  }
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace tagmint

int main(int argc, char** argv) {
  try {
    return tagmint::measure_all({argv + 1, argv + argc});
  } catch (const std::exception& fault) {
    fmt::print(stderr, "whole_searches: {}\n", fault.what());
    return EXIT_FAILURE;
  }
}
