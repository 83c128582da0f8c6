// A whole large family on one sheet: every page is there, and memory stays small.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "support/places.h"
#include "support/rasterise.h"
#include "support/running_program.h"
#include "support/scratch_folder.h"

namespace tagmint::draw {
namespace {

TEST(ManyTags, AllOfALargeFamilyArePrintedIn200Megabytes) {
  const test::ScratchFolder folder;
  const std::string pdf = folder.file("all.pdf");
  // The shell's limit is in KiB and counts all address space, more than what is in memory.
  const std::string command =
      fmt::format("ulimit -v {}; exec '{}' sheet tagStandard52h13 --edge 20mm -o '{}'",
                  200'000'000 / 1024, test::program_path(), pdf);
  const test::ProgramResult result = test::run({"/bin/bash", "-c", command});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.err.find("48714 tags on 2436 pages"), std::string::npos) << result.err;
  const std::string info = test::output_of("pdfinfo '" + pdf + "'");
  EXPECT_NE(info.find("Pages:           2436\n"), std::string::npos) << info;
  const std::string last = test::output_of("pdftotext -f 2436 -l 2436 '" + pdf + "' -");
  EXPECT_NE(last.find("tagStandard52h13 48713"), std::string::npos) << last;
}

}  // namespace
}  // namespace tagmint::draw
