# complete.zsh SCRIPT WORD...: what the script hands to zsh's completion system for the last word; its
# functions, which need a terminal, are stood in for by ones that print their arguments.
script=$1
shift
_describe() { print -rl -- "${(@P)2}" }
_arguments() { print -rl -- "$@" }
words=("$@")
CURRENT=$#
source $script
