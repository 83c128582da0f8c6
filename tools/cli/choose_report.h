#pragma once

#include <string>

#include "cli/choose_plan.h"

namespace tagmint::cli {

/// The recommendation, the table of all families that have enough tags, its notes, and the families
/// left out.
std::string choose_text(const ChoosePlan& plan, const TagUse& use);

/// The same as JSON (docs/choose.md).
std::string choose_json(const ChoosePlan& plan, const TagUse& use);

/// What a caution says, in one line.
///   choice   that has it
std::string caution_text(Caution caution, const FamilyChoice& choice);

/// The command that prints the tags: "tagmint sheet ...".
std::string print_command(const FamilyChoice& choice, const TagUse& use);

/// The command that finds them: "tagmint detect ...".
std::string find_command(const FamilyChoice& choice);

/// "1 in 43,800": a share of all words, for people.
std::string one_in_text(double share);

}  // namespace tagmint::cli
