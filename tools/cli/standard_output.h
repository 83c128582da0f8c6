#pragma once

#include <string_view>

#include "tagmint/codec/errors.h"

namespace tagmint::cli {

/// The reader of our stdout went away (`tagmint ... | head`). The program ends with exit code 4 but
/// says nothing, since nobody asked for more.
class BrokenPipe : public codec::OutputError {
 public:
  using OutputError::OutputError;
};

/// Writes to stdout and flushes it. Throws OutputError with the system's reason, BrokenPipe where
/// the reader is gone.
void write_stdout(std::string_view text);

}  // namespace tagmint::cli
