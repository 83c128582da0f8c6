#!/usr/bin/env bash
# The recipes for Conan and vcpkg, run with stand-ins for these programs, which no Debian package has:
# what they tell CMake are options of ours, and their version is the project's. $1: build, $2: version.
set -euo pipefail
build=$1
version=$2
here="$(cd "$(dirname "$0")" && pwd)"
root="$(cd "$here/../.." && pwd)"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

/usr/bin/python3 -B "$here/run_conan_recipe.py" "$root" "$version"

/usr/bin/python3 - "$build/vcpkg/tagmint/vcpkg.json" "$version" <<'PYTHON'
import json, sys
port = json.load(open(sys.argv[1]))
assert port["name"] == "tagmint" and port["version"] == sys.argv[2], port
PYTHON
cat >"$work/stand_ins.cmake" <<'CMAKE'
foreach(name IN ITEMS vcpkg_cmake_install vcpkg_cmake_config_fixup vcpkg_fixup_pkgconfig vcpkg_install_copyright)
  cmake_language(EVAL CODE "macro(${name})\n message(\"${name} \${ARGN}\")\n endmacro()")
endforeach()
macro(vcpkg_cmake_configure)
  message("vcpkg_cmake_configure ${ARGN}")
endmacro()
include(${PORT})
CMAKE
TAGMINT_SOURCES="$root" cmake -DPORT="$build/vcpkg/tagmint/portfile.cmake" -DVCPKG_LIBRARY_LINKAGE=dynamic \
  -DCURRENT_PACKAGES_DIR="$work/packages" -P "$work/stand_ins.cmake" 2>"$work/calls"
grep -q 'vcpkg_cmake_configure.*TAGMINT_SHARED=ON' "$work/calls" ||
  grep -q 'vcpkg_cmake_configure.*TAGMINT_SHARED=1' "$work/calls" || { cat "$work/calls"; exit 1; }
# Options that we do not have would be passed in vain.
grep -ohE 'TAGMINT_(BUILD_)?[A-Z]+' "$work/calls" "$root/cmake/packaging/conan/conanfile.py" | sort -u |
  while read -r option; do grep -qE "option\($option " "$root/CMakeLists.txt" || { echo "no option $option"; exit 1; }; done
