#include "c_api/boundary.h"

#include <algorithm>
#include <array>

#include "tagmint/codec/version.h"

namespace tagmint::c_api {
namespace {

/// The one message of each thread; room that needs no memory when memory has run out.
std::array<char, 1024>& last_message() noexcept {
  thread_local std::array<char, 1024> message{};
  return message;
}

}  // namespace

tagmint_status fail(tagmint_status status, std::string_view message) noexcept {
  std::array<char, 1024>& kept = last_message();
  const std::size_t length = std::min(message.size(), kept.size() - 1);
  std::copy_n(message.begin(), length, kept.begin());
  kept[length] = '\0';
  return status;
}

}  // namespace tagmint::c_api

extern "C" {

int tagmint_c_version(void) { return TAGMINT_C_VERSION; }

const char* tagmint_version(void) { return tagmint::codec::kVersion.data(); }  // a literal

const char* tagmint_last_error(void) { return tagmint::c_api::last_message().data(); }

}  // extern "C"
