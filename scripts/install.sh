#!/usr/bin/env bash
# Installs the Debian packages that are missing: scripts/install.sh build|test
set -euo pipefail

build=(cmake ninja-build ccache mold g++ libeigen3-dev libopencv-core-dev libopencv-imgproc-dev
  libceres-dev libopenimageio-dev openimageio-tools libcli11-dev nlohmann-json3-dev libfmt-dev
  libtinygltf-dev libcpp-httplib-dev)
test=(clang clang-format libclang-rt-14-dev libgtest-dev libgmock-dev librapidcheck-dev chromium)

wanted=("${build[@]}")
# Node.js of another origin brings its own npm, and Debian's would not go with it.
command -v node > /dev/null || wanted+=(nodejs)
command -v npm > /dev/null || wanted+=(npm)
if [[ ${1:-build} == test ]]; then wanted+=("${test[@]}"); fi

if ! command -v apt-get > /dev/null; then
  echo "This system has no apt-get; hada is built with what these Debian packages hold:" >&2
  echo "${wanted[*]}" >&2
  exit 0
fi

missing=()
for package in "${wanted[@]}"; do
  status=$(dpkg-query -W -f '${Status}' "$package" 2> /dev/null || true)
  if [[ $status != *"ok installed" ]]; then missing+=("$package"); fi
done
if ((${#missing[@]} == 0)); then exit 0; fi

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo > /dev/null; then
    echo "These packages are missing, and only root may install them: ${missing[*]}" >&2
    exit 2
  fi
  as_root=(sudo)
fi
echo "Installing ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -q < /dev/null
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -q -y --no-install-recommends "${missing[@]}" < /dev/null
