#!/usr/bin/env bash
# Installs what Bosk needs and is missing, from Debian's own packages: the one list of packages.
# Why each was chosen and its licence: dependencies.md beside this file. Nothing missing: nothing done,
# no network needed. --developer adds what only the presets `tidy` and clang-format need.
set -euo pipefail

packages=(
  # Tools
  g++ cmake ninja-build ccache pkg-config
  # Computing
  libtbb-dev libglm-dev libopencv-dev libembree-dev libeigen3-dev libmrcal-dev libmrgingham-dev
  # Files
  libopenimageio-dev libexif-dev openimageio-tools libopenexr-dev libimath-dev
  libzstd-dev libxxhash-dev libsquish-dev nlohmann-json3-dev
  # Drawing
  libgl-dev libopengl-dev libegl-dev libgl1-mesa-dri
  # Windows
  libglfw3-dev libimgui-dev fonts-dejavu-core
  # Command line
  libcli11-dev
  # Tests and benchmarks
  libgtest-dev libgmock-dev libbenchmark-dev
  xvfb xdotool
)

if [ "${1:-}" = --developer ]; then
  packages+=(clang clang-tidy clang-format)
elif [ $# -gt 0 ]; then
  echo "usage: install.sh [--developer]" >&2
  exit 2
fi

is_installed() {
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

missing=()
for package in "${packages[@]}"; do
  is_installed "$package" || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

echo "Building Bosk needs ${#missing[@]} Debian packages that are missing (why: third_party/dependencies.md):"
echo "  ${missing[*]}"

give_up() {
  echo "install.sh: $1" >&2
  exit 1
}

command -v apt-get >/dev/null || give_up "this system has no apt-get; install them by hand, then start again."
apt=(env DEBIAN_FRONTEND=noninteractive apt-get -q)
if [ "$(id -u)" -ne 0 ]; then
  apt=(sudo "${apt[@]}")
  if ! command -v sudo >/dev/null || ! "${apt[@]}" --version >/dev/null; then
    give_up "$(id -un) may not install packages. Ask an administrator to run this as root, then start again:
  apt-get install --no-install-recommends ${missing[*]}"
  fi
fi

echo "Installing them with apt-get."
if ! "${apt[@]}" update || ! "${apt[@]}" install -y --no-install-recommends "${missing[@]}"; then
  give_up "apt-get failed, see above. Put the network or /etc/apt/sources.list (Debian 12, main) right, then start again."
fi
