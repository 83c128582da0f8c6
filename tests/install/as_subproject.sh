#!/usr/bin/env bash
# Builds the consumer $1 (subproject, fetch_content), which has tagmint's sources in its own build, and
# runs it. $2: the folder to build in, at the depth of our own builds, where ccache knows all objects;
# $3: the compiler.
set -euo pipefail
name=$1
build=$2
here="$(cd "$(dirname "$0")" && pwd)"
root="$(cd "$here/../.." && pwd)"
rm -rf "$build"
trap 'rm -rf "$build"' EXIT
if command -v ccache >/dev/null; then
  export CMAKE_CXX_COMPILER_LAUNCHER="${CMAKE_CXX_COMPILER_LAUNCHER-ccache}"
  export CCACHE_BASEDIR="${CCACHE_BASEDIR-$root}" CCACHE_NOHASHDIR=1
fi
cmake -S "$here/$name" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$3" \
      -DTAGMINT_SOURCES="$root" -DFETCHCONTENT_SOURCE_DIR_TAGMINT="$root" \
      -DTAGMINT_WARNINGS_AS_ERRORS=ON -DCMAKE_INSTALL_PREFIX="$build/prefix" >/dev/null
nice cmake --build "$build" >/dev/null
"$build/$name"

# Only what the consumer needs: neither program nor tests, and nothing of tagmint is installed with it.
if find "$build" -type f \( -name 'tagmint' -o -name '*_tests' -o -name 'libtagmint.so*' \) | grep .; then
  exit 1
fi
cmake --install "$build" >/dev/null
[ ! -e "$build/prefix" ]
