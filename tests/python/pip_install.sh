#!/usr/bin/env bash
# `pip install .` into a fresh environment, offline, with the system's packages; then the module's tests.
# $1: the folder to compile in, where ccache knows most objects.
set -euo pipefail
here="$(cd "$(dirname "$0")" && pwd)"
root="$(cd "$here/../.." && pwd)"
work=$(mktemp -d)
trap 'rm -rf "$work" "$1"' EXIT
export TAGMINT_PYTHON_BUILD=$1 CMAKE_CXX_COMPILER_LAUNCHER="${CMAKE_CXX_COMPILER_LAUNCHER-ccache}"
export CCACHE_BASEDIR="${CCACHE_BASEDIR-$root}" CCACHE_NOHASHDIR=1
# A copy of what is under version control, for pip leaves files beside the sources.
mkdir "$work/source"
(cd "$root" && git ls-files -z | tar --null -T - -c) | tar -x -C "$work/source"
/usr/bin/python3 -m venv --system-site-packages "$work/environment"
unset PYTHONPATH
"$work/environment/bin/pip" install --no-index --no-build-isolation --no-deps --quiet "$work/source"
cd "$work"
cp "$here/test_tagmint.py" "$work/source/tests/python/"
"$work/environment/bin/python" -c 'import tagmint; assert "environment" in tagmint.__file__, tagmint.__file__'
TAGMINT_SLOW_TESTS=1 "$work/environment/bin/python" "$work/source/tests/python/test_tagmint.py"
"$work/environment/bin/pip" uninstall --yes --quiet tagmint
