#pragma once

#include <fmt/format.h>

#include <new>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "tagmint/codec/errors.h"
#include "tagmint/tagmint.h"

namespace tagmint::c_api {

/// Keeps `message` for tagmint_last_error() of this thread and returns `status`. Of a message that
/// is longer than the room for it the end is cut off. Never throws.
tagmint_status fail(tagmint_status status, std::string_view message) noexcept;

/// Throws std::invalid_argument, naming the argument, when `pointer` is null.
template <typename T>
T& required(T* pointer, std::string_view name) {
  if (pointer == nullptr) {
    throw std::invalid_argument(fmt::format("the argument '{}' is null; give a pointer", name));
  }
  return *pointer;
}

/// Calls body(), which returns a tagmint_status or throws: where exceptions become codes.
template <typename Body>
tagmint_status guarded(Body&& body) noexcept {
  try {
    return std::forward<Body>(body)();
  } catch (const codec::InputError& error) {
    return fail(TAGMINT_ERROR_INPUT, error.what());
  } catch (const std::invalid_argument& error) {
    return fail(TAGMINT_ERROR_ARGUMENT, error.what());
  } catch (const std::bad_alloc&) {
    return fail(TAGMINT_ERROR_MEMORY, "out of memory; ask for less at once");
  } catch (const std::length_error&) {
    return fail(TAGMINT_ERROR_MEMORY, "out of memory; ask for less at once");
  } catch (const std::exception& error) {
    return fail(TAGMINT_ERROR_INTERNAL, error.what());
  } catch (...) {
    return fail(TAGMINT_ERROR_INTERNAL, "an unknown fault");
  }
}

}  // namespace tagmint::c_api
