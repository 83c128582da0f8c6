#pragma once

#include <span>
#include <string>

#include "sha256.h"
#include "tagmint/codec/codeword.h"

namespace tagmint::codec {

/// SHA-256 over codewords, each as 16 lowercase hex digits and a newline.
class CodewordDigest {
 public:
  /// Takes the next codewords.
  void add(std::span<const Codeword> codewords);

  /// The digest of all that were taken; to be asked for once, at the end.
  std::string hex() { return sha256_.hex(); }

 private:
  Sha256 sha256_;
};

}  // namespace tagmint::codec
