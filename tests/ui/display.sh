# For scripts that drive a real window on a display without a screen; sourced, not run. Leaves the
# script in an empty folder of its own, which goes with it.

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
# wait_for WHAT COMMAND...: tries the command for up to 60 s, or PATIENCE: other programs may have
# the machine for a while.
wait_for() {
  local what=$1
  shift
  for _ in $(seq $((5 * ${PATIENCE:-60}))); do
    "$@" >/dev/null 2>&1 && return
    sleep 0.2
  done
  fail "waited in vain for $what"
}

# Built with sanitizers: window drivers keep a little memory to the process's end, which is not ours
export ASAN_OPTIONS=detect_leaks=0

# open_display WIDTHxHEIGHT
open_display() {
  # -noreset: else the server begins anew, and is away for a moment, when a window is killed
  Xvfb -displayfd 3 -screen 0 "$1x24" -nolisten tcp -noreset 3>display 2>/dev/null &
  pids+=($!)
  wait_for "a display" test -s display
  export DISPLAY=":$(cat display)"
  unset WAYLAND_DISPLAY
}

# open_window COMMAND...: starts it, and gives its process in `viewer` and its window in `window`
open_window() {
  "$@" 2>log &
  viewer=$!
  pids+=("$viewer")
  for _ in $(seq 300); do
    window=$(xdotool search --pid "$viewer" --name "Bosk" 2>/dev/null | head -n 1) || true
    [ -n "$window" ] || window=$(xdotool search --name "Bosk" 2>/dev/null | head -n 1) || true
    [ -z "$window" ] || return 0
    if ! kill -0 "$viewer" 2>/dev/null; then
      grep -q "no window with OpenGL 4.5" log && { echo "SKIPPED: $(cat log)"; exit 77; }
      fail "the window's program ended before it opened"
    fi
    sleep 0.2
  done
  fail "no window opened"
}
