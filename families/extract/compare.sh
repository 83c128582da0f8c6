#!/usr/bin/env bash
# Makes the published families anew from the installed libapriltag and compares them with families/.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
fresh=$(mktemp -d)
trap 'rm -rf "$fresh"' EXIT

"$here/extract.sh" "$fresh"
for file in "$fresh"/*.json; do
  cmp "$file" "$here/../$(basename "$file")"
done
echo "all equal"
