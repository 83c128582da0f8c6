#pragma once

#include <functional>

namespace tagmint::cli {

/// Runs `body`, the one place where exceptions end: prints the fault in one line on stderr and
/// returns its exit code; without a fault, what `body` returns.
int report_faults(const std::function<int()>& body);

}  // namespace tagmint::cli
