#pragma once

#include <string>
#include <string_view>

namespace tagmint::cli {

/// A page up to its body: title, style, and a policy that forbids it to fetch anything at all.
std::string page_head(std::string_view title);

/// The end of the body.
std::string page_foot();

}  // namespace tagmint::cli
