#include <algorithm>
#include <string>

#include "c_api/boundary.h"
#include "c_api/objects.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family_file.h"
#include "tagmint/codec/suggest.h"
#include "tagmint/codec/tag_cells.h"

namespace {

using namespace tagmint;
using c_api::guarded;
using c_api::required;

tagmint_status hand_out(codec::SharedFamily family, tagmint_family** result) {
  *result = new tagmint_family{std::move(family)};
  return TAGMINT_OK;
}

codec::Codeword codeword_of(const codec::Family& family, std::uint32_t id) {
  if (id >= family.size()) {
    throw std::invalid_argument(
        fmt::format("{} has no id {}; ids are 0 to {}", family.name(), id, family.size() - 1));
  }
  return family.codeword(id);
}

}  // namespace

extern "C" {

size_t tagmint_bundled_count(void) { return codec::family_names().size(); }

const char* tagmint_bundled_name(size_t index) {
  const auto names = codec::family_names();
  return index < names.size() ? names[index].c_str() : nullptr;
}

tagmint_status tagmint_family_find(const char* name, tagmint_family** family) {
  return guarded([&] {
    const std::string wanted = &required(name, "name");
    required(family, "family");
    codec::SharedFamily found = codec::find_family(wanted);
    if (!found) {
      throw codec::InputError(fmt::format("no family '{}' is bundled", wanted), "",
                              codec::did_you_mean(wanted, codec::family_names()));
    }
    return hand_out(std::move(found), family);
  });
}

tagmint_status tagmint_family_load(const char* name_or_path, tagmint_family** family) {
  return guarded([&] {
    required(name_or_path, "name_or_path");
    required(family, "family");
    return hand_out(codec::load_family(name_or_path), family);
  });
}

tagmint_status tagmint_family_parse(const char* text, size_t size, const char* source,
                                    tagmint_family** family) {
  return guarded([&] {
    required(text, "text");
    required(source, "source");
    required(family, "family");
    return hand_out(
        std::make_shared<const codec::Family>(codec::parse_family({text, size}, source)), family);
  });
}

void tagmint_family_free(tagmint_family* family) { delete family; }

tagmint_status tagmint_family_get_info(const tagmint_family* family, tagmint_family_info* info) {
  return guarded([&] {
    const codec::Family& f = *required(family, "family").family;
    required(info, "info") = {.name = f.name().c_str(),
                              .codes = static_cast<std::uint32_t>(f.size()),
                              .bits = f.bits(),
                              .min_hamming = f.min_hamming(),
                              .safe_errors = f.max_safe_errors(),
                              .width = f.layout().width(),
                              .width_at_border = f.layout().width_at_border(),
                              .reversed_border = f.layout().reversed_border()};
    return TAGMINT_OK;
  });
}

tagmint_status tagmint_family_codeword(const tagmint_family* family, uint32_t id,
                                       uint64_t* codeword) {
  return guarded([&] {
    const codec::Family& f = *required(family, "family").family;
    required(codeword, "codeword");
    *codeword = codeword_of(f, id);
    return TAGMINT_OK;
  });
}

tagmint_status tagmint_family_cells(const tagmint_family* family, uint32_t id, size_t capacity,
                                    char* cells) {
  return guarded([&] {
    const codec::Family& f = *required(family, "family").family;
    required(cells, "cells");
    const codec::TagCells tag = codec::tag_cells(f.layout(), codeword_of(f, id));
    const auto needed = static_cast<std::size_t>(tag.width()) * tag.width();
    if (capacity < needed) {
      throw std::invalid_argument(fmt::format(
          "there is room for {} cells, but {} has {}; give more", capacity, f.name(), needed));
    }
    for (const std::string& row : tag.rows()) cells = std::copy(row.begin(), row.end(), cells);
    return TAGMINT_OK;
  });
}

}  // extern "C"
