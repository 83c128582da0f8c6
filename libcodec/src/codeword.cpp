#include "tagmint/codec/codeword.h"

#include <fmt/format.h>

namespace tagmint::codec {

std::string to_hex(Codeword word) { return fmt::format("0x{:016x}", word); }

}  // namespace tagmint::codec
