#!/usr/bin/env bash
# Installs packages, builds, runs every test but those labelled slow; ends with ctest's summary.
# usage: run.sh            build and test (Release, warnings are errors)
#        run.sh --ci       the same after checking the format and running the unit tests under
#                          AddressSanitizer and UndefinedBehaviorSanitizer (built by Clang)
#        run.sh --slow     the same as run.sh, then the tests labelled slow
set -euo pipefail
cd "$(dirname "$0")/.."

mode="${1:-}"
case "$mode" in
  ""|--ci|--slow) ;;
  *) echo "usage: bash tests/run.sh [--ci|--slow]" >&2; exit 2 ;;
esac

bash tools/install_packages.sh test

# What was compiled before, in this folder or another, is not compiled again.
export CMAKE_CXX_COMPILER_LAUNCHER="${CMAKE_CXX_COMPILER_LAUNCHER-ccache}"
export CCACHE_BASEDIR="$PWD" CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=pch_defines,time_macros

# Configures and builds one preset; the build's own output is shown when it fails or on a terminal.
build() {
  echo "== Building preset $1"
  cmake --preset "$1" >/dev/null
  cmake --build --preset "$1" -- --quiet
}

if [ "$mode" = --ci ]; then
  echo "== Checking the format"
  git ls-files '*.h' '*.cpp' | xargs clang-format-14 --dry-run --Werror
  build asan
  echo "== Unit tests under AddressSanitizer and UndefinedBehaviorSanitizer"
  ctest --preset asan
fi

build ci
if [ "$mode" = --slow ]; then
  echo "== Slow tests"
  ctest --preset ci-slow
fi
echo "== All tests"
ctest --preset ci
