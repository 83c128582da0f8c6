#pragma once

#include <string>
#include <vector>

#include "cluster/round_division.h"
#include "tagmint/codec/codeword.h"
#include "tagmint/codec/search/crew.h"

namespace tagmint::cluster {

/// What travels from the leader to another rank.
struct Task {
  enum class Kind { Begin, Sift, ListOpen, End };
  Kind kind = Kind::End;
  std::string rules;                       ///< Begin: rules_text() of the search
  int number = 0;                          ///< Begin: threads, as local_crew(); End: exit code
  Chunk chunk;                             ///< Sift, ListOpen
  std::vector<codec::Codeword> new_codes;  ///< found since the last task; they count from this one
};

/// What comes back for Sift and ListOpen; answers come in the order of the tasks.
struct Answer {
  Chunk chunk;
  double seconds = 0;  ///< that the work took
  codec::SiftedWords sifted;
  std::vector<codec::Codeword> open;
};

/// The rules of a search as text of four lines: layout, distance, order, complexity.
std::string rules_text(const codec::SearchRules& rules);
/// Turns it back; for texts of this very program only.
codec::SearchRules parse_rules(const std::string& text);

}  // namespace tagmint::cluster
