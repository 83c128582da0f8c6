#pragma once

#include "io/family_kinds/family_kind.h"

namespace tagmint::io {

/// An ArUco dictionary as OpenCV reads it: YAML or JSON, packed where the name ends in .gz.
FamilyKind opencv_kind();

/// FamilyKind::make and FamilyKind::read of this kind.
std::vector<FamilyFile> make_opencv(const codec::Family& family, const std::string& target,
                                    const FamilyWriteOptions& options);
ReadFamily read_opencv(const FamilySource& source, const FamilyReadOptions& options);

/// Keys beside OpenCV's own, which it passes over: the note, and the version whose turn the markers
/// have.
inline constexpr const char* kOpenCvNoteKey = "tagmint_family";
inline constexpr const char* kOpenCvTurnKey = "tagmint_opencv";

}  // namespace tagmint::io
