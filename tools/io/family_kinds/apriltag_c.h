#pragma once

#include "io/family_kinds/family_kind.h"

namespace tagmint::io {

/// C source for libapriltag, NAME.c and NAME.h; reads such files as users have them, also the older
/// tables of AprilTag programs in C, C++ and Java.
FamilyKind apriltag_c_kind();

/// libapriltag keeps ids in 16 bits, and one of them is taken.
inline constexpr std::size_t kMostLibapriltagCodes = 65'535;

/// FamilyKind::make and FamilyKind::read of this kind.
std::vector<FamilyFile> make_apriltag_c(const codec::Family& family, const std::string& target,
                                        const FamilyWriteOptions& options);
ReadFamily read_apriltag_c(const FamilySource& source, const FamilyReadOptions& options);

/// What comes before a note in the comment that carries it.
inline constexpr std::string_view kNoteMark = "tagmint-family: ";

}  // namespace tagmint::io
