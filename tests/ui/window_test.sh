#!/usr/bin/env bash
# Drives the real window of `bosk view` with mouse and keys, on a display without a screen.
#
#   window_test.sh BOSK PACKAGE
#
# Status 77 and a reason where Xvfb or xdotool is missing, or the display has no OpenGL 4.5.
set -euo pipefail
bosk=$(realpath "$1")
package=$(realpath "$2")

for tool in Xvfb xdotool; do
  command -v "$tool" >/dev/null || { echo "SKIPPED: $tool is not installed"; exit 77; }
done

folder=$(mktemp -d)
pids=()
clean_up() {
  [ ${#pids[@]} -eq 0 ] || kill "${pids[@]}" 2>/dev/null || true
  rm -rf "$folder"
}
trap clean_up EXIT
cd "$folder"

fail() {
  echo "FAILED: $*"
  [ ! -s log ] || { echo "bosk said:"; cat log; }
  exit 1
}
# Tries a command for up to 60 s: other programs may have the machine for a while.
wait_for() {
  local what=$1
  shift
  for _ in $(seq 300); do
    "$@" >/dev/null 2>&1 && return
    sleep 0.2
  done
  fail "waited in vain for $what"
}

# Built with sanitizers: window drivers keep a little memory to the process's end, which is not ours
export ASAN_OPTIONS=detect_leaks=0

# Without a display: one clear sentence, bad input
status=0
env -u DISPLAY -u WAYLAND_DISPLAY "$bosk" view "$package" 2>log || status=$?
[ $status -eq 3 ] || fail "without a display: status $status instead of 3"
grep -q "no window can be opened.*--screenshot" log || fail "no remedy is told without a display"

Xvfb -displayfd 3 -screen 0 800x600x24 -nolisten tcp 3>display 2>/dev/null &
pids+=($!)
wait_for "a display" test -s display
export DISPLAY=":$(cat display)"
unset WAYLAND_DISPLAY

start() {
  "$bosk" view "$package" --size 400x300 --trees 3 2>log &
  viewer=$!
  pids+=("$viewer")
  for _ in $(seq 300); do
    window=$(xdotool search --name "Bosk" 2>/dev/null | head -n 1) || true
    [ -z "$window" ] || return 0
    if ! kill -0 "$viewer" 2>/dev/null; then
      grep -q "no window with OpenGL 4.5" log && { echo "SKIPPED: $(cat log)"; exit 77; }
      fail "the viewer ended before its window opened"
    fi
    sleep 0.2
  done
  fail "no window opened"
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
