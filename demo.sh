#!/usr/bin/env bash
set -euo pipefail
here=$PWD
cd "$(dirname "${BASH_SOURCE[0]}")"
source ./.setup.sh

read_arguments "Usage: ./demo.sh [--no-install]

Builds the program and renders figure 9 (a), a glass cylinder on a glass decahedron, through the emulated frame
buffer to fig9a.png in the current folder. Installs packages that are missing (Debian, with apt; with sudo where
not root).

  --no-install  install nothing; say what is missing instead" "$@"
require_packages "${packages[@]}" "${display_packages[@]}"
build_release halftone m508

start=$(date +%s%N)
build/release/halftone render scenes/fig9a.toml -o "$here/fig9a.png"
end=$(date +%s%N)

milliseconds=$(((end - start) / 1000000))
printf -v file %q "$here/fig9a.png"
printf '\nThe picture:   %s\n' "$here/fig9a.png"
printf 'It took:       %d.%d s, rendered, sent to the frame buffer and read back from it\n' \
  $((milliseconds / 1000)) $((milliseconds % 1000 / 100))
printf 'To look at it: xdg-open %s\n' "$file"
printf 'To watch it:   build/release/halftone view scenes/fig9b.toml\n'
