#!/usr/bin/env bash
# Draws the scenes scaled, moved and in contact with every contender, and writes their table into docs/stability.md:
#   tests/bench/stability.sh build/release [FOLDER]     # FOLDER: of the results, by default bench
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/tests/support/into_page.sh"
folder=${2:-bench}
"${1:?the folder of a release build}/tests/bench/halftone-bench" --stability \
  --scenes opaque,round,fig9b,fig9a-gaps,fig9a -o "$folder"
into_page "$root/docs/stability.md" contenders <"$folder/stability.txt"
