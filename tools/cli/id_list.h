#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "tagmint/codec/family.h"

namespace tagmint::cli {

/// Ids of a family from a list of ids and ranges: "0-9,12,20-". A range without an end runs to the
/// last id.
///   family_size   number of ids in the family; they count from 0
///   option        named in the message, for example "--ids"
///   returns       ascending, each id once
/// Throws UsageError naming the part at fault, also for an id that the family lacks.
std::vector<codec::TagId> parse_id_list(std::string_view text, std::size_t family_size,
                                        std::string_view option = "--ids");

}  // namespace tagmint::cli
