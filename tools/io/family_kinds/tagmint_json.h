#pragma once

#include "io/family_kinds/family_kind.h"

namespace tagmint::io {

/// tagmint's own family files (docs/family-format.md).
FamilyKind tagmint_json_kind();

}  // namespace tagmint::io
