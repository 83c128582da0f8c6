#!/usr/bin/env bash
# Writes families/*.json anew from the libapriltag that is installed (Debian: libapriltag-dev 3.3).
# Usage: families/extract/extract.sh [FOLDER]     FOLDER: where to write; default families/
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
folder=${1:-$root/families}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The family files are part of the library, so what writes them is built from single sources.
sources=(atomic_file codeword codeword_digest colour_changes complexity errors family
         family_builder family_document family_fields family_file family_rules kernels/orbit_kernels layout
         layout_presets level_tags posix_file rectangle_painter rotation_code sha256 suggest
         tag_index)
paths=()
for source in "${sources[@]}"; do paths+=("$root/libcodec/src/$source.cpp"); done
# The headers of libapriltag include each other without their folder.
"${CXX:-g++}" -std=c++20 -O1 -I"$root/libcodec/include" -I"$root/libcodec/src" \
  -isystem /usr/include/apriltag \
  "$root/families/extract/extract_families.cpp" "${paths[@]}" \
  -o "$work/extract_families" -DHWY_SHARED_DEFINE -lapriltag -lfmt -lcrypto -lhwy
mkdir -p "$folder"
"$work/extract_families" "$folder"
