#!/usr/bin/env bash
# The project's version, $1, has one home: what repeats it for people agrees with it.
set -euo pipefail
version=$1
cd "$(dirname "$0")/../.."
fail() { echo "$*; the project is $version"; exit 1; }
newest=$(sed -n 's/^## \([0-9.]*\).*/\1/p' CHANGELOG.md | sed -n 1p)
[ "$newest" = "$version" ] || fail "CHANGELOG.md begins with $newest"
while IFS=: read -r file line; do
  [[ $line == *"find_package(tagmint ${version%.*} "* ]] || fail "$file: $line"
done < <(grep -rE --include='*.md' --include=CMakeLists.txt 'find_package\(tagmint [0-9]' README.md docs tests/install)
[ "$(/usr/bin/python3 -B setup.py --version 2>/dev/null | tail -1)" = "$version" ] || fail "setup.py says another version"
