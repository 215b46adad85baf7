#!/usr/bin/env bash
# How long a row takes to the window, and a key to what it does, while a render keeps all processors busy:
#
#   tests/display/latency.sh [BUILD]
#
# Under Xvfb, with the X11 driver of a desktop. Prints the median and the worst of 40 of each.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
build=$(realpath "${1:-build/release}")
needed=()
source tests/display/under_xvfb.sh
[[ -x $build/tests/display/measure_latency ]] ||
  { echo "latency.sh: $build has no measure_latency; install libxtst-dev and build again" >&2; exit 1; }

"$build/m508" serve --display window --listen "unix:$folder/socket" >/dev/null 2>&1 &
processes+=($!)
windows_of "${processes[-1]}" "$folder/window"

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
