#!/usr/bin/env bash
# Makes the tables of docs/families.md: builds families_table and runs it, with the dictionaries of
# the npm package js-aruco2 where npm is installed and reaches its registry.
# Usage: bash tests/bench/families_table/make_tables.sh [BUILD_FOLDER] > tables.md
#        BUILD_FOLDER: a configured one; default build/release, which is configured if need be
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

build=${1:-$root/build/release}
{
  [ -n "${1:-}" ] || (cd "$root" && cmake --preset release)
  cmake -DTAGMINT_BUILD_BENCH=ON "$build"
  cmake --build "$build" --target families_table
} >&2
if command -v npm >/dev/null && npm install --silent --prefix "$work" js-aruco2@2.0.0 >&2; then
  node "$here/npm_dictionaries.cjs" "$work/node_modules/js-aruco2" "$work"
else
  echo "make_tables.sh: without the dictionaries of js-aruco2, which npm did not get" >&2
fi
shopt -s nullglob
"$build/tests/bench/families_table" "$work"/*.dict
