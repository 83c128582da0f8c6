#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/places.h"
#include "support/running_program.h"

namespace tagmint::test {

/// The built program's path followed by `arguments`.
inline std::vector<std::string> tagmint_words(const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {program_path()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

/// Runs the built program.
inline ProgramResult tagmint(const std::vector<std::string>& arguments) {
  return run(tagmint_words(arguments));
}

/// Expects that the program failed with that exit code and one line, `tagmint: error: FAULT`, and
/// wrote nothing to stdout.
inline void expect_fault(const std::vector<std::string>& arguments, int exit_code,
                         const std::string& fault) {
  const ProgramResult result = tagmint(arguments);
  SCOPED_TRACE(::testing::PrintToString(arguments));
  EXPECT_EQ(result.exit_code, exit_code);
  EXPECT_EQ(result.err, "tagmint: error: " + fault + "\n");
  EXPECT_EQ(result.out, "");
}

}  // namespace tagmint::test
