#!/usr/bin/env bash
# Installs the build in $1 to a fresh prefix and compiles programs in C++ and C with nothing but what
# pkg-config says: with the shared library, and with the static ones.
set -euo pipefail
build=$1
version=$2
root="$(cd "$(dirname "$0")/../.." && pwd)"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake --install "$build" --prefix "$work/prefix" --strip >/dev/null
# Moved after installing: the files find their folders from where they are.
mv "$work/prefix" "$work/moved"
export PKG_CONFIG_PATH
PKG_CONFIG_PATH=$(dirname "$(find "$work/moved" -name tagmint.pc)")
[ "$(pkg-config --modversion tagmint)" = "$version" ]
[ "$(pkg-config --modversion tagmint-static)" = "$version" ]

library=$(find "$work/moved" -name libtagmint.so)
for package in tagmint tagmint-static; do
  read -ra cflags < <(pkg-config --cflags $package)
  read -ra libs < <(pkg-config --libs $package)
  c++ -std=c++20 -Wall -Wextra -Werror "${cflags[@]}" "$root/tests/install/consumer/main.cpp" \
      "${libs[@]}" -o "$work/$package"
  cc -std=c11 -pedantic -Wall -Wextra -Werror "${cflags[@]}" "$root/docs/examples/c_api.c" \
      "${libs[@]}" -o "$work/c-$package"
  for program in "$work/$package" "$work/c-$package"; do
    LD_LIBRARY_PATH=$(dirname "$library") "$program"
    needs=$(readelf -d "$program" | grep -c 'NEEDED.*libtagmint\.so' || true)
    [ "$needs" = "$([ $package = tagmint ] && echo 1 || echo 0)" ]
  done
done
