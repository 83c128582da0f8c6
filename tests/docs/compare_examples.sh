#!/usr/bin/env bash
# Compares a document with the programs it shows: each block of code is a file of FOLDER, named in its
# first line, and each file of FOLDER is shown; the block of text after it is what the program prints.
#   compare_examples.sh DOCUMENT FOLDER PROGRAM...    the programs are called as their sources
set -euo pipefail
document=$1
folder=$2
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/shown" "$work/run"

# Splits the document into shown/NAME.EXT and shown/NAME.out.
awk -v out="$work/shown" '
  # state: outside of blocks, or in a block of code, of text, of another language
  /^```/ && state != "" { state = ""; next }
  /^```(cpp|c)$/ { state = "code"; file = ""; next }
  /^```$/ { state = "text"; first = 1; next }
  /^```/ { state = "other"; next }
  state == "code" && file == "" {
    if (!match($0, /docs\/examples\/[a-z_]+\.(cpp|c)/)) { print "a block of code without a name: " $0; exit 1 }
    name = substr($0, RSTART + 14, RLENGTH - 14); file = out "/" name
  }
  state == "code" { print > file }
  state == "text" && first { first = 0; file = ""; if ($1 == "$") file = out "/" $2 ".out"; next }
  state == "text" && file != "" { print > file }
' "$document"

for source in "$folder"/*; do
  name=$(basename "$source")
  [ -e "$work/shown/$name" ] || { echo "$document does not show $name"; exit 1; }
  diff "$source" "$work/shown/$name"
done
for program in "$@"; do
  name=$(basename "$program")
  name=${name#example_}
  [ -e "$work/shown/$name.out" ] || { echo "$document does not show what $name prints"; exit 1; }
  (cd "$work/run" && "$(realpath "$program")" 2>/dev/null) | sed 's/ *$//' >"$work/$name.out"
  diff "$work/shown/$name.out" "$work/$name.out"
done
