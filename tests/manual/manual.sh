#!/usr/bin/env bash
# The manual pages are clean and complete; bash and fish complete commands, options and values; zsh's
# completion system is given what it needs.
#   manual.sh PROGRAM FOLDER    tagmint, and what tagmint_manual wrote
set -euo pipefail
program=$1
folder=$2
here="$(cd "$(dirname "$0")" && pwd)"
fail() { echo "$*"; exit 1; }

commands=$("$program" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z][a-z]*\) .*/\1/p')
[ "$(wc -w <<<"$commands")" -ge 14 ]

# Pages: no warnings of groff, and each option that the help has.
for page in "$folder"/man/*.1; do
  warnings=$(LC_ALL=C.UTF-8 MANROFFSEQ='' MANWIDTH=80 man --warnings -E UTF-8 -l -Tutf8 -Z "$page" 2>&1 >/dev/null)
  [ -z "$warnings" ] || fail "$page: $warnings"
done
for command in $commands; do
  text=$(LC_ALL=C.UTF-8 MANWIDTH=80 man -l "$folder/man/tagmint-$command.1")
  for option in $("$program" "$command" --help | grep -oE '^  (-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+'); do
    grep -qe "$option" <<<"$text" || fail "tagmint-$command.1 has no $option"
    grep -qe "$option" "$folder/tagmint.bash" || fail "tagmint.bash has no $option"
  done
  grep -q "tagmint-$command(1)" <<<"$(LC_ALL=C.UTF-8 man -l "$folder/man/tagmint.1")" ||
    fail "tagmint.1 does not name tagmint-$command"
done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
touch photo.png 'my family.json'
mkdir out

# expect SHELL GOT WANTED: the words in any order
expect() {
  [ "$(sort <<<"$2")" = "$(sort <<<"$3")" ] || fail "$1 offers '$2', not '$3'"
}
lines() { printf '%s\n' "$@"; }

complete_in_bash() { bash --norc "$here/complete.bash" "$folder/tagmint.bash" "$@"; }
expect bash "$(complete_in_bash tagmint ident)" identify
expect bash "$(complete_in_bash tagmint ch)" "$(lines choose check)"
expect bash "$(complete_in_bash tagmint detect --deb)" --debug
expect bash "$(complete_in_bash tagmint detect --family tagCircle2)" tagCircle21h7
expect bash "$(complete_in_bash tagmint detect --debug o)" out
expect bash "$(complete_in_bash tagmint detect --family tag36h11 ph)" photo.png
expect bash "$(complete_in_bash tagmint info my)" 'my family.json'
expect bash "$(complete_in_bash tagmint families --format '')" "$(lines text json)"
expect bash "$(complete_in_bash tagmint families --progress al)" always
expect bash "$(complete_in_bash tagmint detect --threads '')" ""

complete_in_fish() { # the words alone, without their descriptions
  HOME="$work" fish --no-config -c "source '$folder/tagmint.fish'; complete -C \"$1\"" | cut -f1
}
expect fish "$(complete_in_fish 'tagmint ident')" identify
expect fish "$(complete_in_fish 'tagmint detect --deb')" --debug
expect fish "$(complete_in_fish 'tagmint families --format ')" "$(lines text json)"
expect fish "$(complete_in_fish 'tagmint detect --family tagCircle2')" tagCircle21h7
expect fish "$(complete_in_fish 'tagmint detect --overlay ph')" photo.png

zsh -f -n "$folder/_tagmint"
complete_in_zsh() { zsh -f "$here/complete.zsh" "$folder/_tagmint" "$@"; }
[ "$(complete_in_zsh tagmint '' | cut -d: -f1)" = "$commands" ] || fail "zsh is not offered all commands"
complete_in_zsh tagmint detect '' | grep -q '^\*--family\[.*\]:FAMILY:_tagmint_families$'
complete_in_zsh tagmint families '' | grep -q '^\*--format\[.*\]:text|json:(text json)$'
complete_in_zsh tagmint detect '' | grep -q '^\*:IMAGE:_files$'
