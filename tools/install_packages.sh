#!/usr/bin/env bash
# Installs the Debian 12 packages that tagmint is built from, through apt-get as root or with sudo.
# usage: install_packages.sh build          what the program and the quick start need
#        install_packages.sh test           the same and what the tests need
# Packages that are already there cost no network.
set -euo pipefail

build=(build-essential cmake ninja-build pkg-config
       libfmt-dev libhwy-dev libssl-dev libtbb-dev nlohmann-json3-dev libeigen3-dev
       libcairo2-dev libpng-dev libjpeg-dev libtiff-dev zlib1g-dev libcli11-dev
       libpoppler-glib-dev librsvg2-dev fonts-dejavu-core poppler-utils)
test=(ccache libgtest-dev clang clang-format-14 libclang-rt-14-dev libboost-mpi-dev openmpi-bin
      libapriltag-dev libopencv-dev librsvg2-bin qpdf libxml2-utils python3-yaml ghostscript
      chromium zsh fish man-db groff-base
      python3-pybind11 pybind11-dev python3-numpy python3-venv python3-pip python3-setuptools
      python3-wheel python3-mypy doxygen graphviz gcovr clang-tidy-14 cppcheck)

case "${1:-}" in
  build) wanted=("${build[@]}") ;;
  test) wanted=("${build[@]}" "${test[@]}") ;;
  *) echo "usage: $0 build|test" >&2; exit 2 ;;
esac

missing=()
for package in "${wanted[@]}"; do
  state=$(dpkg-query -W -f '${Status}' "$package" 2>/dev/null || true)
  [ "$state" = "install ok installed" ] || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

run_as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "install_packages.sh: needs root or sudo to install: ${missing[*]}" >&2; exit 1; }
  run_as_root=(sudo)
fi
echo "== Installing packages: ${missing[*]}"
"${run_as_root[@]}" apt-get update -qq
"${run_as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
