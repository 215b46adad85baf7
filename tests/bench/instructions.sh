#!/usr/bin/env bash
# Counts the instructions of three small renders with callgrind, and compares them with those in instructions.txt:
#   tests/bench/instructions.sh build/release              # fails where one has risen by more than 5 %
#   tests/bench/instructions.sh --record build/release     # writes instructions.txt anew
# Times of a machine that does other things say nothing of a change of a few per cent; these counts do. Those of
# another compiler say nothing either: then, and where there is no valgrind, nothing is counted and this is said.
set -euo pipefail

limit=5 # per cent
scenes=(opaque fig9b round)
# Small, so that all of it takes half a minute, but not so small that what is prepared for a picture is all of it.
width=160 height=120

fail() {
  printf 'instructions.sh: %s\n' "$1" >&2
  exit 2
}

skip() {
  printf 'Skipped: %s\n' "$1"
  exit 0
}

record=no
if [[ ${1:-} == --record ]]; then
  record=yes
  shift
fi
(($# == 1)) || fail 'usage: instructions.sh [--record] BUILD'
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$(cd "$1" && pwd) || fail "$1: the folder of a release build is needed"
table=$root/tests/bench/instructions.txt
[[ -x $build/halftone ]] || fail "$build has no program halftone"
grep -qx 'CMAKE_BUILD_TYPE:STRING=Release' "$build/CMakeCache.txt" || fail "$build is no release build"

# "GNU 12.2.0 x86_64", as CMake has found it.
compiler=$(sed -nE 's/^set\(CMAKE_CXX_COMPILER_(ID|VERSION) "(.*)"\)$/\2/p' "$build"/CMakeFiles/*/CMakeCXXCompiler.cmake |
  tr '\n' ' ')$(uname -m)

if ! command -v valgrind >/dev/null; then
  [[ $record == no ]] || fail 'valgrind is not installed'
  skip 'valgrind is not installed, so no instructions are counted'
fi
if ! grep -qw avx2 /proc/cpuinfo; then
  [[ $record == no ]] || fail 'this processor has no AVX2'
  skip 'this processor has no AVX2, with which the instructions were recorded'
fi
recorded_compiler=$(sed -n 's/^compiler //p' "$table" || true)
[[ $record == yes || $compiler == "$recorded_compiler" ]] ||
  skip "instructions.txt was recorded with $recorded_compiler, and this is $compiler"

work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

# The whole process: there is nothing in it that depends on time, and starting takes three million of them.
count() {
  sed "s/^width = .*/width = $width/; s/^height = .*/height = $height/" "$root/scenes/$1.toml" >"$work/$1.toml"
  valgrind --tool=callgrind --callgrind-out-file=/dev/null \
    "$build/halftone" render "$work/$1.toml" --threads 1 --simd avx2 -o "$work/$1.png" >"$work/$1.log" 2>&1 ||
    fail "counting $1 has failed: $(cat "$work/$1.log")"
  sed -n 's/.*Collected : //p' "$work/$1.log"
}

if [[ $record == yes ]]; then
  {
    printf '# Instructions of halftone render --threads 1 --simd avx2 at %d x %d, by callgrind (instructions.sh --record).\n' \
      "$width" "$height"
    printf 'compiler %s\n' "$compiler"
    for scene in "${scenes[@]}"; do
      now=$(count "$scene")
      printf '%s %s\n' "$scene" "$now"
    done
  } >"$work/table"
  cp "$work/table" "$table"
  cat "$table"
  exit
fi

risen=()
printf '%-8s %15s %15s %9s\n' scene recorded now change
for scene in "${scenes[@]}"; do
  recorded=$(sed -n "s/^$scene //p" "$table")
  [[ $recorded ]] || fail "$scene is not in instructions.txt; run instructions.sh --record"
  now=$(count "$scene")
  change=$(awk -v a="$recorded" -v b="$now" 'BEGIN { printf "%+.2f", 100 * (b - a) / a }')
  printf '%-8s %15s %15s %7s %%\n' "$scene" "$recorded" "$now" "$change"
  if awk -v c="$change" -v limit=$limit 'BEGIN { exit !(c > limit) }'; then risen+=("$scene"); fi
done
if ((${#risen[@]})); then
  printf 'More than %d %% more instructions: %s. Where that is meant: tests/bench/instructions.sh --record\n' \
    "$limit" "${risen[*]}" >&2
  exit 1
fi
