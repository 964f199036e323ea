#!/usr/bin/env bash
# Installs what Bosk needs and is missing, from Debian's own packages: the one list of packages.
# Why each was chosen and its licence: dependencies.md beside this file. Nothing missing: nothing done,
# no network needed.
set -euo pipefail

packages=(
  # Tools
  g++ cmake ninja-build ccache pkg-config
  # Computing
  libtbb-dev libglm-dev libopencv-dev libembree-dev
  # Files
  libopenimageio-dev openimageio-tools libopenexr-dev libimath-dev
  libzstd-dev libxxhash-dev libsquish-dev nlohmann-json3-dev
  # Drawing
  libgl-dev libopengl-dev libegl-dev libgl1-mesa-dri
  # Command line
  libcli11-dev
  # Tests and benchmarks
  libgtest-dev libgmock-dev libbenchmark-dev
)

is_installed() {
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

missing=()
for package in "${packages[@]}"; do
  is_installed "$package" || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

if ! command -v apt-get >/dev/null; then
  echo "install.sh: this system has no apt-get; install these by hand: ${missing[*]}" >&2
  exit 1
fi
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "install.sh: not root and no sudo; ask an administrator to install: ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

echo "Installing ${#missing[@]} Debian packages that building Bosk needs (why: third_party/dependencies.md):"
echo "  ${missing[*]}"
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -q
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
