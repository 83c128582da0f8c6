#!/usr/bin/env bash
# Installs the build in $1 to a fresh prefix, builds a consumer in C++ and one in C against it and runs
# the programs.
set -euo pipefail
build=$1
here="$(cd "$(dirname "$0")" && pwd)"
root="$here/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake --install "$build" --prefix "$work/prefix" >/dev/null

# build_consumer NAME CMAKE_ARGUMENTS...
build_consumer() {
  cmake -S "$here/$1" -B "$work/$1" -G Ninja -DCMAKE_BUILD_TYPE=Release \
        -DCMAKE_PREFIX_PATH="$work/prefix" "${@:2}" >/dev/null
  cmake --build "$work/$1" >/dev/null
  "$work/$1/$1"
}
build_consumer consumer
[ -z "$(find "$work/prefix" -name libtagmint.so)" ] || build_consumer consumer -DLIBRARY=tagmint::tagmint
build_consumer c_consumer -DPROGRAM="$root/docs/examples/c_api.c"

# The program that README shows is this one.
sed -n '/^```cpp$/,/^```$/p' "$root/README.md" | sed '1d;$d' >"$work/readme.cpp"
diff "$work/readme.cpp" "$here/consumer/main.cpp"
"$work/prefix/bin/tagmint" --version
ls "$work"/prefix/share/tagmint/families/tag36h11.json >/dev/null
