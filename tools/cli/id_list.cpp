#include "cli/id_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <numeric>
#include <string>

#include "cli/command.h"
#include "cli/number.h"

namespace tagmint::cli {
namespace {

using codec::TagId;

/// Reads one list; its members are what every message needs.
class IdListParser {
 public:
  IdListParser(std::string_view text, std::size_t family_size, std::string_view option)
      : text_(text), family_size_(family_size), option_(option) {}

  std::vector<TagId> parse() const {
    std::vector<TagId> ids;
    for (std::size_t begin = 0; begin <= text_.size();) {
      const std::size_t end = std::min(text_.find(',', begin), text_.size());
      add_part(trimmed(text_.substr(begin, end - begin)), ids);
      begin = end + 1;
    }
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    return ids;
  }

 private:
  void add_part(std::string_view part, std::vector<TagId>& ids) const {
    const std::size_t dash = part.find('-');
    const std::uint64_t first = parse_id(part, trimmed(part.substr(0, dash)));
    std::uint64_t last = first;
    if (dash != std::string_view::npos) {
      const std::string_view end = trimmed(part.substr(dash + 1));
      last = end.empty() ? family_size_ - 1 : parse_id(part, end);
    }
    if (first > last) {
      throw UsageError(fmt::format("the id range '{}' runs backwards", part), option_,
                       fmt::format("write {}-{}", last, first));
    }
    const std::size_t before = ids.size();
    ids.resize(before + static_cast<std::size_t>(last - first + 1));
    std::iota(ids.begin() + static_cast<std::ptrdiff_t>(before), ids.end(),
              static_cast<TagId>(first));
  }

  std::uint64_t parse_id(std::string_view part, std::string_view digits) const {
    std::uint64_t id = 0;
    const char* end_of_digits = digits.data() + digits.size();
    const auto [end, error] = std::from_chars(digits.data(), end_of_digits, id);
    const bool number = !digits.empty() && end == end_of_digits;
    if (!number || (error != std::errc() && error != std::errc::result_out_of_range)) {
      throw UsageError(fmt::format("'{}' in the id list '{}' is not an id", part, text_), option_,
                       "write ids and ranges, like 0-9,12,20-");
    }
    if (error == std::errc::result_out_of_range || id >= family_size_) {
      throw UsageError(fmt::format("id {} is not in the family", digits), option_,
                       fmt::format("its ids are 0-{}", family_size_ - 1));
    }
    return id;
  }

  std::string_view text_;
  std::size_t family_size_;
  std::string_view option_;
};

}  // namespace

std::vector<TagId> parse_id_list(std::string_view text, std::size_t family_size,
                                 std::string_view option) {
  return IdListParser(text, family_size, option).parse();
}

}  // namespace tagmint::cli
