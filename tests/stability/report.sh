#!/usr/bin/env bash
# Runs the large counts of every family, two cases at a time, and writes their table into docs/stability.md:
#   tests/stability/report.sh build/release
# Fails where a family does, after writing the table.
set -euo pipefail

# In a function, so that the shell has read all of it before the hours that it takes.
report() {
  local root build page test_stability part k
  root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
  build=$(cd "${1:?the folder of a release build}" && pwd)
  page=$root/docs/stability.md
  source "$root/tests/support/into_page.sh"
  test_stability=$build/tests/stability/test_stability

  parts=$(mktemp -d)
  trap 'rm -r "$parts"' EXIT

  # Each case into a part of its own, in the order of their files. A failed count is a line of the table.
  mapfile -t cases < <("$test_stability" --list-test-names-only "[long]" || true)
  test ${#cases[@]} -gt 0
  for k in "${!cases[@]}"; do
    if ((k > 1)); then wait -n || true; fi
    part=$parts/$(printf %02d "$k")
    (
      trap - EXIT
      HALFTONE_STABILITY_TABLE=$part.part "$test_stability" "${cases[k]//,/\\,}" >"$part.log" 2>&1 ||
        touch "$part.failed"
    ) &
  done
  wait

  {
    printf '| family | cases | failures | worst | its input |\n|---|---|---|---|---|\n'
    cat "$parts"/*.part
  } | into_page "$page" table
  if compgen -G "$parts/*.failed" >/dev/null; then
    cat "$parts"/*.log >&2
    return 1
  fi
}

report "$@"
exit
