#!/usr/bin/env bash
# Runs the large counts of every family, two at a time, and writes their table into docs/stability.md:
#   tests/stability/report.sh build/release
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$(cd "${1:?the folder of a release build}" && pwd)
page=$root/docs/stability.md

parts=$(mktemp -d)
trap 'rm -r "$parts"' EXIT

# The cases in the order of their files, each into a part of its own; a failed count is a line of the table.
"$build/tests/stability/test_stability" --list-test-names-only "[long]" | sed 's/,/\\,/g' >"$parts/names" || true
test -s "$parts/names"
nl -n rz -w 3 -s $'\t' "$parts/names" |
  xargs -P 2 -d '\n' -I{} bash -c '
    line={}
    HALFTONE_STABILITY_TABLE=$2/${line%%	*}.part "$1/tests/stability/test_stability" "${line#*	}" >"$2/${line%%	*}.log" 2>&1 ||
      echo "failed: ${line#*	}" >&2' _ "$build" "$parts"

{
  sed '/<!-- table -->/q' "$page"
  printf '\n| family | cases | failures | worst | its input |\n|---|---|---|---|---|\n'
  cat "$parts"/*.part
  printf '\n'
  sed -n '/<!-- end of table -->/,$p' "$page"
} >"$parts/page"
cp "$parts/page" "$page"
