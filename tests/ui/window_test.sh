#!/usr/bin/env bash
# Drives the real window of `bosk view` with mouse and keys, on a display without a screen.
#
#   window_test.sh BOSK PACKAGE
#
# Status 77 and a reason where Xvfb or xdotool is missing, or the display has no OpenGL 4.5.
set -euo pipefail
bosk=$(realpath "$1")
package=$(realpath "$2")

source "$(dirname "$(realpath "$0")")/display.sh"

# Without a display: one clear sentence, bad input
status=0
env -u DISPLAY -u WAYLAND_DISPLAY "$bosk" view "$package" 2>log || status=$?
[ $status -eq 3 ] || fail "without a display: status $status instead of 3"
grep -q "no window can be opened.*--screenshot" log || fail "no remedy is told without a display"

open_display 800x600

start() {
  open_window "$bosk" view "$package" --size 400x300 --trees 3
}
# Saves the picture as the given number by the key P.
picture() {
  xdotool mousemove --window "$window" 200 270
  xdotool windowfocus "$window" 2>/dev/null || true
  sleep 0.5
  xdotool key p
  wait_for "picture $1" test -s "bosk-000$1.png"
}

# A picture, then another from elsewhere after a drag, then one with false colours
start
picture 1
xdotool key Tab  # else the panels would be under the mouse
sleep 0.5
xdotool mousemove --window "$window" 150 250
sleep 0.3
xdotool mousedown 1
sleep 0.3
for x in 170 190 210 230 250; do
  xdotool mousemove --window "$window" $x 255
  sleep 0.1
done
xdotool mouseup 1
sleep 0.3
picture 2
! cmp -s bosk-0001.png bosk-0002.png || fail "dragging did not turn the picture"
xdotool key c
sleep 0.5
picture 3
! cmp -s bosk-0002.png bosk-0003.png || fail "the key c did not change the colours"
for k in h h Tab v 3 w Home; do xdotool key $k; sleep 0.3; done
grep -q "bosk-0003.png" log || fail "pictures are not told"

# Unmapped, tiny and back again
xdotool windowunmap "$window"; sleep 0.5
xdotool windowmap "$window"; sleep 0.5
xdotool windowsize "$window" 1 1; sleep 0.5
xdotool windowsize "$window" 300 200; sleep 0.5
kill -0 "$viewer" || fail "the viewer ended while its window changed size"

# At rest it uses next to no processor
ticks() { awk '{print $14 + $15}' "/proc/$viewer/stat"; }
sleep 4
before=$(ticks)
sleep 2
after=$(ticks)
[ $((after - before)) -lt 100 ] || fail "at rest the viewer used $((after - before)) ticks in 2 s"

xdotool windowfocus "$window" 2>/dev/null || true
xdotool mousemove --window "$window" 150 150
sleep 0.3
xdotool key Escape
status=0
wait "$viewer" || status=$?
[ $status -eq 0 ] || fail "closing: status $status"

# SIGINT ends it in order
start
kill -INT "$viewer"
status=0
wait "$viewer" || status=$?
[ $status -eq 130 ] || fail "SIGINT: status $status instead of 130"
echo "the window opened, turned, changed colours, was hidden, rested and closed"
