#include "scene/json_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "tagmint/codec/suggest.h"

namespace tagmint::scene {

using codec::InputError;
using nlohmann::json;

void JsonValue::fail(const std::string& what, const std::string& mend) const {
  throw InputError(fmt::format("{} {}", path_.empty() ? whole_ : path_, what), source_, mend);
}

void JsonValue::require_keys(std::initializer_list<std::string_view> keys) const {
  if (!json_->is_object()) {
    fail("is not an object", fmt::format("write {{...}} with the keys {}", fmt::join(keys, ", ")));
  }
  const std::vector<std::string> known(keys.begin(), keys.end());
  for (const auto& [key, value] : json_->items()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const std::string hint = codec::did_you_mean(key, known);
    fail(fmt::format("has an unknown key '{}'", key),
         hint.empty() ? fmt::format("the keys are {}", fmt::join(known, ", ")) : hint);
  }
}

bool JsonValue::has(std::string_view key) const { return json_->contains(key); }

JsonValue JsonValue::at(std::string_view key) const {
  if (!has(key)) fail(fmt::format("lacks '{}'", key), "add it");
  return {(*json_)[std::string(key)], source_,
          path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key), whole_};
}

std::string JsonValue::only_key() const {
  if (!json_->is_object() || json_->size() != 1) {
    fail("does not name one kind", "give exactly one");
  }
  return json_->begin().key();
}

std::vector<JsonValue> JsonValue::elements() const {
  if (!json_->is_array()) fail("is not a list", "write [...]");
  std::vector<JsonValue> values;
  for (std::size_t i = 0; i < json_->size(); ++i) {
    values.emplace_back((*json_)[i], source_, fmt::format("{}[{}]", path_, i), whole_);
  }
  return values;
}

double JsonValue::number() const {
  constexpr double kAny = std::numeric_limits<double>::max();
  return number(-kAny, kAny);
}

double JsonValue::number(double low, double high) const {
  if (!json_->is_number()) fail("is not a number", "write one without quotes");
  const double value = json_->get<double>();
  if (!(value >= low && value <= high)) {
    fail(fmt::format("is {}", value), fmt::format("it must be from {} to {}", low, high));
  }
  return value;
}

std::uint64_t JsonValue::whole(std::uint64_t low, std::uint64_t high) const {
  if (!json_->is_number_unsigned() || json_->get<std::uint64_t>() < low ||
      json_->get<std::uint64_t>() > high) {
    fail(fmt::format("is {}", json_->dump()),
         fmt::format("it must be a whole number from {} to {}", low, high));
  }
  return json_->get<std::uint64_t>();
}

std::string JsonValue::text() const {
  if (!json_->is_string()) fail("is not a text", "write it in double quotes");
  return json_->get<std::string>();
}

json parse_json(std::string_view text, const std::string& source) {
  std::vector<std::set<std::string>> keys;
  std::string twice;
  const auto watch = [&](int, json::parse_event_t event, json& value) {
    if (event == json::parse_event_t::object_start) keys.emplace_back();
    if (event == json::parse_event_t::object_end) keys.pop_back();
    if (event == json::parse_event_t::key && !keys.back().insert(value.get<std::string>()).second) {
      twice = value.get<std::string>();
    }
    return true;
  };
  json parsed;
  try {
    parsed = json::parse(text, watch);
  } catch (const json::parse_error& error) {
    const std::size_t end = std::min(error.byte, text.size());
    const auto lines =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
    throw InputError("not valid JSON", fmt::format("{}:{}", source, lines + 1),
                     "look for a missing comma, quote or bracket there");
  }
  if (!twice.empty()) {
    throw InputError(fmt::format("the key '{}' is given twice", twice), source, "keep one of them");
  }
  return parsed;
}

}  // namespace tagmint::scene
