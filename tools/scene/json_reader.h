#pragma once

#include <array>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tagmint/codec/errors.h"

namespace tagmint::scene {

/// A value inside a JSON file that knows where it is, so that every fault names the file and the
/// place, like "scene.json: tags[2].edge_m". Refers to `json`, which must outlive it.
class JsonValue {
 public:
  ///   whole   how messages call the value of the whole file
  JsonValue(const nlohmann::json& json, std::string source, std::string path = "",
            std::string_view whole = "the scene")
      : json_(&json), source_(std::move(source)), path_(std::move(path)), whole_(whole) {}

  /// Throws InputError unless this is an object all of whose keys are among `keys`; names the
  /// nearest one for a misspelt key.
  void require_keys(std::initializer_list<std::string_view> keys) const;
  bool has(std::string_view key) const;
  /// The member `key`; throws InputError when it is missing. require_keys() comes first.
  JsonValue at(std::string_view key) const;
  /// The only member's key, of an object that names one of several kinds; throws InputError when
  /// there is not exactly one.
  std::string only_key() const;
  /// The elements; throws InputError when this is no array.
  std::vector<JsonValue> elements() const;

  /// A finite number in [low, high]; throws InputError otherwise.
  double number(double low, double high) const;
  double number() const;
  /// A whole number in [low, high]; throws InputError otherwise.
  std::uint64_t whole(std::uint64_t low, std::uint64_t high) const;
  std::string text() const;
  /// An array of exactly N numbers.
  template <std::size_t N>
  std::array<double, N> numbers() const {
    std::array<double, N> values{};
    const std::vector<JsonValue> given = elements();
    if (given.size() != N) {
      fail("has " + std::to_string(given.size()) + " numbers",
           "give " + std::to_string(N) + " of them");
    }
    for (std::size_t i = 0; i < N; ++i) values[i] = given[i].number();
    return values;
  }

  /// Throws InputError "PATH WHAT (SOURCE); HOW TO MEND".
  [[noreturn]] void fail(const std::string& what, const std::string& mend) const;

 private:
  const nlohmann::json* json_;
  std::string source_;
  std::string path_;
  std::string_view whole_;  // of static storage
};

/// Parses JSON text; throws InputError with the line of the fault. A key given twice is a fault.
nlohmann::json parse_json(std::string_view text, const std::string& source);

}  // namespace tagmint::scene
