#!/usr/bin/env bash
# Installs the build in $1 to a fresh prefix, builds the consumer against it and runs both programs.
set -euo pipefail
build=$1
consumer="$(cd "$(dirname "$0")" && pwd)/consumer"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake --install "$build" --prefix "$work/prefix" >/dev/null
cmake -S "$consumer" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
      -DCMAKE_PREFIX_PATH="$work/prefix" >/dev/null
cmake --build "$work/build" >/dev/null
"$work/build/consumer"
# The program that README shows is this one.
sed -n '/^```cpp$/,/^```$/p' "$consumer/../../../README.md" | sed '1d;$d' >"$work/readme.cpp"
diff "$work/readme.cpp" "$consumer/main.cpp"
"$work/prefix/bin/tagmint" --version
ls "$work"/prefix/share/tagmint/families/tag36h11.json >/dev/null
