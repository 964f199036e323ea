# How a script finds its way in the workstation's window: by the file that --landmarks keeps, here
# "marks". Sourced after display.sh.

sees() { grep -q "^$1 " marks; }
is_enabled() { grep -q "^$1 .* 1$" marks; }
middle_of() { awk -v name="$1" '$1 == name { print int(($2 + $4) / 2), int(($3 + $5) / 2) }' marks; }

# click LANDMARK: waits until it can be used
click() {
  wait_for "$1 to be there" sees "$1"
  wait_for "$1 to be of use" is_enabled "$1"
  local place
  read -r -a place <<<"$(middle_of "$1")"
  xdotool mousemove --window "$window" "${place[0]}" "${place[1]}"
  sleep 0.3
  xdotool click 1
  sleep 0.5
}
# Into the field that has the keyboard
write() {
  xdotool type --delay 15 "$1"
  sleep 0.5
}
press() {
  xdotool key "$1"
  sleep 0.5
}

# stroke X0 Y0 X1 Y1: a drag over the photo, places as shares of its width and height
stroke() {
  local from to
  read -r -a from <<<"$(photo_place "$1" "$2")"
  read -r -a to <<<"$(photo_place "$3" "$4")"
  xdotool mousemove --window "$window" "${from[0]}" "${from[1]}"
  sleep 0.2
  xdotool mousedown 1
  for step in 1 2 3 4 5 6 7 8; do
    xdotool mousemove --window "$window" \
      $((from[0] + (to[0] - from[0]) * step / 8)) $((from[1] + (to[1] - from[1]) * step / 8))
    sleep 0.03
  done
  xdotool mouseup 1
  sleep 0.2
}
# Where that is in the window: the photo, upright 3 : 4, fills its canvas as far as it can
photo_place() {
  awk -v x="$1" -v y="$2" '$1 == "matte/canvas" {
    width = $4 - $2; height = $5 - $3
    scale = width / 3 < height / 4 ? width / 3 : height / 4
    print int($2 + width / 2 + (x - 0.5) * 3 * scale), int($3 + height / 2 + (y - 0.5) * 4 * scale)
  }' marks
}

strokes_in() { "$bosk" info "$1" --json 2>/dev/null | grep -o '"strokes": [0-9]*' | grep -o '[0-9]*$' || echo 0; }
has_strokes() { [ "$(strokes_in "$1")" -eq "$2" ]; }

nothing_runs() { ! sees job/stop; }
wait_until_done() {
  sleep 1
  wait_for "the job's end" nothing_runs
  sleep 1
}

# picture NAME: of the whole screen, where pictures are wanted
picture() {
  [ -n "${pictures:-}" ] || return 0
  sleep 1
  import -window root "$pictures/$1.png"
}
