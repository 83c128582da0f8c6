#!/usr/bin/env bash
# Makes the Debian packages of the build in $1, version $2, unpacks them into a folder and uses them
# there: the program, and consumers in C++ and C. Nothing is installed on this machine; dpkg only says
# whether it would.
set -euo pipefail
build=$1
version=$2
abi=$3
here="$(cd "$(dirname "$0")" && pwd)"
root="$here/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cpack -G DEB --config "$build/CPackConfig.cmake" -B "$work/packages" >"$work/log" 2>&1 ||
  { cat "$work/log"; exit 1; }
cd "$work/packages"
architecture=$(dpkg --print-architecture)
packages=()
for name in "libtagmint$abi" libtagmint-dev tagmint; do
  file=${name}_${version}_$architecture.deb
  [ "$(dpkg-deb -f "$file" Version)" = "$version" ]
  dpkg -x "$file" "$work/root"
  packages+=("$PWD/$file")
done
[ "$(find . -maxdepth 1 -name '*.deb' | wc -l)" -eq 3 ]

# What each needs was found from its binaries, and is named by package.
depends() { dpkg-deb -f "$1"_*.deb Depends; }
depends "libtagmint$abi" | grep -q 'libfmt9.*libssl3\|libssl3.*libfmt9'
depends libtagmint-dev | grep -q "^libtagmint$abi (= $version), "
depends tagmint | grep -q libcairo2
dpkg-deb --ctrl-tarfile "libtagmint${abi}"_*.deb | tar -xO ./shlibs | grep -q "^libtagmint $abi libtagmint$abi"
# All that they need is there: dpkg would install them.
dpkg --dry-run --force-not-root --force-bad-path -i "${packages[@]}" >"$work/dry" 2>&1 || { cat "$work/dry"; exit 1; }

# The development package puts its links and nothing of the runtime in place.
test "$(dpkg -c libtagmint-dev_*.deb | grep -c 'libtagmint\.so ->')" -eq 1
library=$(dirname "$(find "$work/root" -name 'libtagmint.so.*.*.*')")
export LD_LIBRARY_PATH=$library
"$work/root/usr/bin/tagmint" --version | grep -qx "tagmint $version"
"$work/root/usr/bin/tagmint" check "$work/root/usr/share/tagmint/families/tag16h5.json" >/dev/null
for consumer in "consumer -DLIBRARY=tagmint::tagmint" "c_consumer -DLIBRARY=tagmint::tagmint -DPROGRAM=$root/docs/examples/c_api.c"; do
  read -ra words <<<"$consumer"
  cmake -S "$here/${words[0]}" -B "$work/${words[0]}" -G Ninja -DCMAKE_BUILD_TYPE=Release \
        -DCMAKE_PREFIX_PATH="$work/root/usr" "${words[@]:1}" >/dev/null
  cmake --build "$work/${words[0]}" >/dev/null
  readelf -d "$work/${words[0]}/${words[0]}" | grep -q "NEEDED.*libtagmint.so.$abi"
  "$work/${words[0]}/${words[0]}"
done
