#include "io/family_kinds/tagmint_json.h"

#include "io/family_kinds/family_changes.h"
#include "tagmint/codec/family_file.h"

namespace tagmint::io {
namespace {

bool recognises(const FamilySource& source) {
  return source.content.find("\"tagmint-family\"") != std::string::npos &&
         source.content.find_first_not_of(" \t\r\n") == source.content.find('{');
}

ReadFamily read(const FamilySource& source, const FamilyReadOptions& options) {
  return {with_options(codec::parse_family(source.content, source.name), options)};
}

std::vector<FamilyFile> make(const codec::Family& family, const std::string& target,
                             const FamilyWriteOptions&) {
  return {{target, codec::format_family(family)}};
}

}  // namespace

FamilyKind tagmint_json_kind() {
  return {.name = "tagmint",
          .summary = "tagmint's own family file, holds everything",
          .extensions = {".json"},
          .holds_generators = true,
          .recognises = recognises,
          .read = read,
          .make = make};
}

}  // namespace tagmint::io
