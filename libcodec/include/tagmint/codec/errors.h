#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "tagmint/codec/export.h"

namespace tagmint::codec {

/// A fault outside the program, told in three parts that become one line: "WHAT (WHERE); HOW TO
/// MEND". `where` and `mend` may be empty. Programs print what() and choose the exit code by the
/// subclass.
class TAGMINT_API Fault : public std::runtime_error {
 public:
  Fault(std::string_view what, std::string_view where, std::string_view mend);
};

/// An input that cannot be read or is malformed.
class TAGMINT_API InputError : public Fault {
 public:
  using Fault::Fault;
};

/// An output that cannot be written.
class TAGMINT_API OutputError : public Fault {
 public:
  using Fault::Fault;
};

}  // namespace tagmint::codec
