#!/usr/bin/env bash
# From nothing to a report: installs what is missing, builds hada, and takes a virtual sheet of
# wrinkled paper the whole way from its photographs to more of its surface.
set -euo pipefail
cd "$(dirname "$0")"

scripts/install.sh build
cmake --preset default -DHADA_BUILD_TESTS=OFF -DHADA_BUILD_BENCH=OFF > /dev/null
cmake --build build --target hada
build/hada demo -o out/demo
echo "Open $PWD/out/demo/report.html"
