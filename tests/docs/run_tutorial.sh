#!/usr/bin/env bash
# Runs the commands of a page in order, in an empty folder, and compares what they print with what the page shows.
#   run_tutorial.sh PAGE PROGRAM    blocks marked sh are run; a plain block after one is all that it prints
set -euo pipefail
page=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/blocks" "$work/bin" "$work/run"
ln -s "$(realpath "$2")" "$work/bin/tagmint"
export PATH="$work/bin:$PATH"

# blocks/NN.sh, and blocks/NN.out where the page shows what it prints.
awk -v out="$work/blocks" '
  /^```/ && state != "" { state = ""; next }
  /^```sh$/ { file = sprintf("%s/%02d", out, ++count); state = ".sh"; next }
  /^```$/ { state = ".out"; next }
  /^```/ { state = "other"; next }
  state == ".sh" || state == ".out" { print > (file state) }
' "$page"

cd "$work/run"
for block in "$work"/blocks/*.sh; do
  if ! bash -euo pipefail "$block" >"$work/printed" 2>&1; then
    cat "$block" "$work/printed"
    exit 1
  fi
  shown="${block%.sh}.out"
  [ ! -e "$shown" ] || diff "$shown" "$work/printed"
done
echo "$(ls "$work"/blocks/*.sh | wc -l) blocks of commands run, $(ls "$work"/blocks/*.out | wc -l) compared"
