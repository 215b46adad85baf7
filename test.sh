#!/usr/bin/env bash
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
source ./.setup.sh

read_arguments "Usage: ./test.sh [--no-install]

Builds everything in release and runs every test. Installs packages that are missing (Debian, with apt; with sudo
where not root).

  --no-install  install nothing; say what is missing instead" "$@"
# A client in another language, and a reader of reports; windows that nobody has to look at.
require_packages "${packages[@]}" python3 "${display_test_packages[@]}"
build_release all

ctest --test-dir build/release --output-on-failure -j"$(nproc)"
