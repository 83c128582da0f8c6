#!/usr/bin/env bash
# From nothing to a detected tag: installs packages, builds tagmint, makes a family, prints it, finds it.
# usage: quickstart.sh [FOLDER]       FOLDER takes the files that are made (default: out/quickstart)
set -euo pipefail
cd "$(dirname "$0")/.."
out="${1:-out/quickstart}"

bash tools/install_packages.sh build
echo "== Building (Release)"
cmake --preset release -DTAGMINT_BUILD_TESTS=OFF >/dev/null
cmake --build --preset release --target tagmint -- --quiet
tagmint=build/release/tagmint
mkdir -p "$out"
rm -f "$out"/scan*

# Shows a command, then runs it.
show() {
  printf '\n$ %s\n' "$*"
  "$@"
}

# The number of different ids among the detections of a jsonl file.
count_ids() { grep -o '"id":[0-9]*' "$1" | sort -u | wc -l; }

echo
echo "== 1. Make a family of our own: 25 data bits, any two tags at least 9 bits apart"
show "$tagmint" generate --layout standard:7 --min-hamming 9 -o "$out/my.json"
show "$tagmint" check "$out/my.json"
tags=$("$tagmint" info "$out/my.json" --format json | grep -o '"codes": *[0-9]*' | head -1 | grep -o '[0-9]*$')

echo
echo "== 2. Print all $tags tags, the detected square exactly 20 mm wide"
show "$tagmint" sheet "$out/my.json" --edge 20mm --paper a4 --ruler -o "$out/sheet.pdf"

echo
echo "== 3. Scan the print (300 dpi) and find every tag"
show pdftoppm -r 300 -gray -png "$out/sheet.pdf" "$out/scan"
show "$tagmint" detect --family "$out/my.json" --format jsonl -o "$out/scan.jsonl" "$out"/scan*.png
found=$(count_ids "$out/scan.jsonl")
echo "found $found of $tags tags"
[ "$found" -eq "$tags" ] || { echo "quickstart: tags are missing in the scan" >&2; exit 1; }

echo
echo "== 4. A camera's view: perspective, blur, noise"
show "$tagmint" render "$out/my.json" --count 12 --size 1280x960 --min-side 30 --max-side 80 --max-tilt 50 \
     --blur 0.8 --noise 4 --seed 7 -o "$out/scene.png" --truth "$out/scene-truth.json"
show "$tagmint" detect --family "$out/my.json" --overlay "$out/scene-found.png" --require "$out/scene.png"

echo
echo "== Done. In $out:"
echo "  my.json           the family          sheet.pdf        print it at 100 %"
echo "  scan*.png         the print as pixels scene.png        the rendered view"
echo "  scan.jsonl        what was found      scene-found.png  the view with its detections drawn"
