#!/usr/bin/env bash
# A person's way through the workstation, in the real window with mouse and keyboard: from photos to
# a package that equals, byte for byte, the one that the command line makes of the same project.
#
#   workstation_session.sh BOSK [PICTURES]
#
# PICTURES: a folder for a picture of every step (needs ImageMagick's `import`). Status 77 and a
# reason where Xvfb or xdotool is missing, or the display has no OpenGL 4.5.
set -euo pipefail
bosk=$(realpath "$1")
pictures=${2:+$(realpath "$2")}
here=$(dirname "$(realpath "$0")")
source "$here/display.sh"
source "$here/landmarks.sh"
export XDG_CONFIG_HOME=$folder/config
PATIENCE=300

"$bosk" phantom capture --quiet --preset sparse --photos 8 --width_px "${WIDTH_PX:-180}" \
  --height_px "${HEIGHT_PX:-240}" >/dev/null 2>&1 || fail "no sample capture"

open_display 1400x900
open_window "$bosk" open --landmarks marks
wait_for "the start page" sees start/folder
picture start

click start/folder
write "$folder/oak"
click start/make
wait_for "an open project" sees step/photos

# Photos
click photos/path
write "$folder/capture/photos"
click photos/add
wait_for "thumbnails" sees photos/tile/000
wait_for "all of them" sees photos/tile/007
picture photos

# Cameras
click step/calibrate
click calibrate/path
write "$folder/capture/transforms.json"
click calibrate/import
wait_for "cameras" sees calibrate/row/000
picture calibrate

# Strokes over the tree and over its background
click step/matte
wait_for "a photo to paint on" sees matte/canvas
sleep 1
stroke 0.42 0.35 0.58 0.45
stroke 0.50 0.55 0.50 0.80
press x
stroke 0.04 0.05 0.96 0.05
stroke 0.04 0.10 0.04 0.95
stroke 0.96 0.10 0.96 0.95
wait_for "five strokes in the project" test "$(strokes_in oak)" -eq 5
press ctrl+z
wait_for "one less" has_strokes oak 4
press ctrl+shift+z
wait_for "it again" has_strokes oak 5
click matte/run
wait_until_done
picture matte

# Volume, textures, codebook
click step/volume
click volume/run_radiance
wait_until_done
picture volume
click step/textures
click textures/run
wait_until_done
picture textures
click step/codebook
click codebook/run
wait_until_done
picture codebook

# The tree, and what is written
click step/preview
click preview/make
wait_until_done
sleep 3
picture preview
click step/export
wait_for "the package's place" sees export/package/write
click export/package/write
wait_for "the package" test -s oak/oak.bosk
wait_for "word of it" sees export/package/told
picture export

press ctrl+q
status=0
wait "$viewer" || status=$?
[ $status -eq 0 ] || fail "closing: status $status"

# The same project without what the workstation has made
mkdir -p again/oak
cp oak/project.json again/oak/
cp -r capture again/
"$bosk" run again/oak --quiet -o command-line.bosk >/dev/null 2>log || fail "the command line could not run it"
cmp oak/oak.bosk command-line.bosk || fail "window and command line made different packages"
echo "from photos to package in the window, and the same bytes from the command line"
