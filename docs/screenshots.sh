#!/usr/bin/env bash
# Makes the pictures of display.md: docs/screenshots.sh [BUILD]. Needs xvfb, xdotool, imagemagick, gvncviewer,
# novnc, websockify, chromium and python3.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=$(realpath "${1:-build/release}")
needed=(import gvncviewer websockify chromium python3)
source tests/display/under_xvfb.sh

"$build/halftone" render scenes/fig9b.toml -o "$folder/out.png" --record "$folder/fig9b.m508"
"$build/m508" replay "$folder/fig9b.m508" --display window >"$folder/told" &
processes+=($!)
windows_of "${processes[-1]}" "$folder/window"
window=$(head -1 "$folder/window")
sleep 2 # until it has the picture: what is pressed before is not heard

# Long enough for the window to have done it, on a machine that is busy.
act() {
  xdotool "$@"
  sleep 1
}
shoot() { import -window "$window" -depth 8 "PNG24:docs/$1.png"; }

act mousemove --window "$window" 660 400 click 3 # that part of the stream
shoot display-paint
act key End
act mousemove --window "$window" 486 436 click --repeat 2 --delay 200 4 click 1
shoot display-probe
act key Escape 0 h
shoot display-help
act key q

"$build/m508" replay "$folder/fig9b.m508" --display vnc:127.0.0.1:0 --display web:127.0.0.1:0 >"$folder/told" &
processes+=($!)
until_true grep -q '^display web' "$folder/told"
vnc=$(sed -n 's/^display vnc on 127.0.0.1://p' "$folder/told")
gvncviewer "127.0.0.1:$((vnc - 5900))" >"$folder/client" 2>&1 &
processes+=($!)
windows_of "${processes[-1]}" "$folder/window"
window=$(tail -1 "$folder/window")
sleep 2 # until it has the picture
shoot display-vnc

python3 tests/display/browser.py "$(sed -n 's/^display web on //p' "$folder/told")" "$folder/page.png" 900 640 &
processes+=($!)
until_true test -s "$folder/page.png"
sleep 8 # until noVNC has the picture, and has put its words away
cp "$folder/page.png" docs/display-web.png
