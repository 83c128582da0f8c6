#!/usr/bin/env bash
# What the shared library $1 exports is what the public headers mark with TAGMINT_API, no less and no
# more: functions, and classes with their members, vtables and type information. $2: the version of
# each symbol.
set -euo pipefail
library=$1
version=$2
root="$(cd "$(dirname "$0")/../.." && pwd)"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# marked FOLDER: the names of marked classes and functions, in a file each.
marked() {
  cat $(find "$root/$1" -name '*.h') >"$work/headers"
  grep -oE '^(class|struct) TAGMINT_API \w+' "$work/headers" | awk '{print $3}' | sort -u >"$work/classes"
  grep -oE '^TAGMINT_API [^(]*\(' "$work/headers" | sed -E 's/.*[ *&](\w+)\($/\1/' | sort -u >"$work/functions"
  [ -s "$work/functions" ]
}

nm -D --defined-only "$library" | awk '$2 != "A" {print $3}' >"$work/versioned"
if grep -v "@@$version\$" "$work/versioned"; then
  echo "these have not the version $version"
  exit 1
fi
# Without versions, arguments and ABI tags: tagmint::codec::Layout::rows.
sed 's/@@.*//' "$work/versioned" | c++filt |
  sed -E 's/^(typeinfo|typeinfo name|vtable) for //; s/\(.*//; s/\[abi:[a-z0-9]*\]//' | sort -u >"$work/names"

for space in codec detect; do
  marked "lib$space/include/tagmint/$space"
  sed -n "s/^tagmint::$space:://p" "$work/names" >"$work/exported"
  sed 's/::.*//' "$work/exported" | sort -u >"$work/offered"
  sort -u "$work/classes" "$work/functions" >"$work/allowed"
  extra=$(comm -23 "$work/offered" "$work/allowed")
  missing=$(comm -13 "$work/offered" "$work/functions")
  [ -z "$extra" ] || { echo "exported, but not public: $extra"; exit 1; }
  [ -z "$missing" ] || { echo "public, but not exported: $missing"; exit 1; }
done
marked libdetect/include/tagmint
grep '^tagmint_' "$work/names" >"$work/exported"
grep '^tagmint_' "$work/functions" >"$work/allowed"
diff "$work/allowed" "$work/exported"
if grep -vE '^tagmint(_|::codec::|::detect::)' "$work/names"; then
  echo "these are not of the project"
  exit 1
fi
echo "$(wc -l <"$work/names") names of version $version"
