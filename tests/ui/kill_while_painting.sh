#!/usr/bin/env bash
# Kills the workstation while a person paints, with a stroke under the brush, again and again: every
# stroke that was ended over a second before is there when the project is opened again.
#
#   kill_while_painting.sh BOSK          (BOSK_KILLS rounds, 2 unless set)
#
# Status 77 and a reason where Xvfb or xdotool is missing, or the display has no OpenGL 4.5.
set -euo pipefail
bosk=$(realpath "$1")
here=$(dirname "$(realpath "$0")")
source "$here/display.sh"
source "$here/landmarks.sh"
export XDG_CONFIG_HOME=$folder/config

"$bosk" phantom capture --quiet --preset sparse --photos 4 --width_px 120 --height_px 160 \
  >/dev/null 2>&1 || fail "no sample capture"
"$bosk" new oak capture/photos --cameras capture/transforms.json --quiet >/dev/null 2>&1 ||
  fail "no project"
open_display 1400x900

now_ms() { date +%s%3N; }
place() { echo "0.$((RANDOM % 80 + 10))"; }

kept=0
for round in $(seq "${BOSK_KILLS:-2}"); do
  rm -f marks
  open_window "$bosk" open oak --landmarks marks
  wait_for "the project" test -s marks
  has_strokes oak "$kept" || fail "round $round opened with $(strokes_in oak) strokes instead of $kept"
  click step/matte
  wait_for "a photo to paint on" sees matte/canvas
  sleep 1
  ends=()
  for _ in $(seq $((RANDOM % 4 + 2))); do
    stroke "$(place)" "$(place)" "$(place)" "$(place)"
    ends+=("$(now_ms)")
    ! ((RANDOM % 3)) || press x
  done
  # A stroke is under the brush when it happens
  read -r -a from <<<"$(photo_place 0.3 0.3)"
  xdotool mousemove --window "$window" "${from[0]}" "${from[1]}"
  xdotool mousedown 1
  xdotool mousemove --window "$window" $((from[0] + 40)) $((from[1] + 20))
  sleep "0.$((RANDOM % 10))"
  kill -9 "$viewer"
  killed=$(now_ms)
  wait "$viewer" 2>/dev/null || true
  xdotool mouseup 1
  due=$kept
  for end in "${ends[@]}"; do ((killed - end < 1000)) || due=$((due + 1)); done
  most=$((kept + ${#ends[@]}))
  kept=$(strokes_in oak)
  [ "$kept" -ge "$due" ] || fail "round $round: $kept strokes are left of $due that were ended a second before"
  [ "$kept" -le "$most" ] || fail "round $round: $kept strokes, and only $most were painted"
done
[ "$kept" -gt 0 ] || fail "nothing was painted at all"
echo "$kept strokes outlived ${BOSK_KILLS:-2} kills"
