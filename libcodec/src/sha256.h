#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace tagmint::codec {

/// SHA-256 of bytes that come piece by piece. The functions throw std::runtime_error when OpenSSL
/// cannot compute it.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(const Sha256&) = delete;
  Sha256& operator=(const Sha256&) = delete;

  void add(std::string_view bytes);

  /// The digest of all bytes so far as 64 lowercase hex digits; to be asked for once, at the end.
  std::string hex();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

/// SHA-256 of the bytes, as 64 lowercase hex digits.
std::string sha256_hex(std::string_view bytes);

}  // namespace tagmint::codec
