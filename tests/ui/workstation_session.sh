#!/usr/bin/env bash
# A person's way through the workstation, in the real window with mouse and keyboard: from photos to
# a package that equals, byte for byte, the one that the command line makes of the same project.
#
#   workstation_session.sh BOSK [PICTURES CAPTURE]
#
# PICTURES: a folder for a picture of every step (needs ImageMagick's `import`); CAPTURE: what
# `bosk phantom CAPTURE --width_px 720 --height_px 960` made, else a small one is made. The README's
# pictures are these. Status 77 and a reason where Xvfb or xdotool is missing, or the display has no
# OpenGL 4.5.
set -euo pipefail
bosk=$(realpath "$1")
pictures=${2:+$(realpath "$2")}
capture=${3:+$(realpath "$3")}
here=$(dirname "$(realpath "$0")")
source "$here/display.sh"
source "$here/landmarks.sh"
export XDG_CONFIG_HOME=$folder/config
PATIENCE=300

if [ -n "$capture" ]; then
  cp -r "$capture" capture
  smaller=0
else
  "$bosk" phantom capture --quiet --photos 8 --width_px 180 --height_px 240 >/dev/null 2>&1 ||
    fail "no sample capture"
  smaller=6
fi

# Without a display: one clear sentence, bad input
for command in "$bosk" "$bosk open"; do
  status=0
  env -u DISPLAY -u WAYLAND_DISPLAY $command 2>log || status=$?
  [ $status -eq 3 ] || fail "without a display: status $status instead of 3"
  grep -q "no window can be opened.*bosk --help" log || fail "no remedy is told without a display"
done

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
wait_for "the last of a screenful" sees photos/tile/007
sleep $((20 - 2 * smaller))  # until they are read
picture photos

# Cameras
click step/calibrate
click calibrate/path
write "$folder/capture/transforms.json"
click calibrate/import
wait_for "cameras" sees calibrate/row/000
sleep 3
picture calibrate

# Strokes over the tree and over its background
click step/matte
wait_for "a photo to paint on" sees matte/canvas
wait_for "the photo itself" sees matte/photo/000
sleep 2
for ((i = 0; i < smaller; ++i)); do press bracketleft; done
stroke 0.35 0.50 0.45 0.45
stroke 0.55 0.45 0.65 0.55
stroke 0.50 0.29 0.50 0.40
stroke 0.20 0.55 0.26 0.55
stroke 0.496 0.70 0.496 0.75
press x
stroke 0.05 0.08 0.95 0.10
stroke 0.05 0.30 0.22 0.24
stroke 0.95 0.30 0.97 0.60
stroke 0.05 0.94 0.95 0.92
stroke 0.08 0.66 0.06 0.88
stroke 0.18 0.74 0.43 0.76
stroke 0.56 0.76 0.85 0.72
wait_for "twelve strokes in the project" has_strokes oak 12
press ctrl+z
wait_for "one less" has_strokes oak 11
press ctrl+shift+z
wait_for "it again" has_strokes oak 12
press f
picture strokes
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
click codebook/curve
wait_until_done
picture codebook

# The tree, and what is written
click step/preview
click preview/make
wait_until_done
sleep 3
picture preview
click preview/compare
wait_for "a photo to compare with" sees preview/picture
sleep 3
picture compare
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
cp -rL capture again/
"$bosk" run again/oak --quiet -o command-line.bosk >/dev/null 2>log || fail "the command line could not run it"
cmp oak/oak.bosk command-line.bosk || fail "window and command line made different packages"
echo "from photos to package in the window, and the same bytes from the command line"
