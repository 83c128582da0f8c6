#pragma once

#include <string>
#include <string_view>

namespace tagmint::codec {

/// SHA-256 of the bytes, as 64 lowercase hex digits. Throws std::runtime_error when OpenSSL cannot
/// compute it.
std::string sha256_hex(std::string_view bytes);

}  // namespace tagmint::codec
