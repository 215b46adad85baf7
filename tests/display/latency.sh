#!/usr/bin/env bash
# How long a row takes to the window, and a key to what it does, while a render keeps all processors busy:
#
#   tests/display/latency.sh [BUILD]
#
# Under Xvfb, with the X11 driver of a desktop. Prints the median and the worst of 40 of each.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
build=$(realpath "${1:-build/release}")
for tool in Xvfb xdotool python3; do
  command -v "$tool" >/dev/null || { echo "latency.sh: $tool is not installed" >&2; exit 1; }
done
folder=$(mktemp -d)
processes=()
finish() {
  ((${#processes[@]} == 0)) || kill "${processes[@]}" 2>/dev/null || true
  rm -rf "$folder"
}
trap finish EXIT

Xvfb -displayfd 3 -screen 0 1280x1100x24 -nolisten tcp 3>"$folder/display" 2>/dev/null &
processes+=($!)
until [[ -s $folder/display ]]; do sleep 0.05; done
DISPLAY=:$(cat "$folder/display")
export DISPLAY

"$build/m508" serve --display window --listen "unix:$folder/socket" >/dev/null 2>&1 &
processes+=($!)
until xdotool search --onlyvisible --pid "${processes[-1]}" >"$folder/window" 2>/dev/null; do sleep 0.05; done

(
  trap 'kill "$render"; exit' TERM
  while true; do
    "$build/halftone" render scenes/fig9b.toml --mode full -o "$folder/out.png" &
    render=$!
    wait "$render"
  done
) &
processes+=($!)
sleep 1
"$build/tests/display/measure_latency" "unix:$folder/socket" "$(head -1 "$folder/window")"
