#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test. No display and no root needed (only to install).
set -euo pipefail
cd "$(dirname "$0")"
./third_party/install.sh
cmake --preset release
cmake --build --preset release
ctest --preset release --parallel "$(nproc)"
