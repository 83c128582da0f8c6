#!/usr/bin/env bash
# `pip install .` into a fresh environment, offline, with the system's packages; then the module's tests.
# $1: the folder to compile in, at the depth and with the flags of our own builds, where ccache knows all
# objects.
set -euo pipefail
here="$(cd "$(dirname "$0")" && pwd)"
root="$(cd "$here/../.." && pwd)"
work=$(mktemp -d)
trap 'rm -rf "$work" "$1" "$root"/build/lib.* "$root"/build/bdist.* "$root"/build/temp.* "$root"/*.egg-info' EXIT
export TAGMINT_PYTHON_BUILD=$1 CMAKE_ARGS=-DTAGMINT_WARNINGS_AS_ERRORS=ON
if command -v ccache >/dev/null; then
  export CMAKE_CXX_COMPILER_LAUNCHER="${CMAKE_CXX_COMPILER_LAUNCHER-ccache}"
  export CCACHE_BASEDIR="${CCACHE_BASEDIR-$root}" CCACHE_NOHASHDIR=1
fi
/usr/bin/python3 -m venv --system-site-packages "$work/environment"
unset PYTHONPATH
"$work/environment/bin/pip" install --no-index --no-build-isolation --no-deps --quiet "$root"
cd "$work"
"$work/environment/bin/python" -c 'import tagmint; assert "environment" in tagmint.__file__, tagmint.__file__'
"$work/environment/bin/python" -B "$here/test_tagmint.py"
"$work/environment/bin/pip" uninstall --yes --quiet tagmint
