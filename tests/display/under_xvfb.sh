# What scripts share that look at windows: sourced, with the project's folder as the current one, after `needed` has the
# programs. Sets up a folder and a desktop of their own, and ends what they start, by process id, when they end.
# Adds processes to end to `processes`.

for tool in Xvfb xdotool "${needed[@]}"; do
  command -v "$tool" >/dev/null || { echo "${0##*/}: $tool is not installed" >&2; exit 1; }
done
folder=$(mktemp -d)
processes=()
finish() {
  ((${#processes[@]} == 0)) || kill "${processes[@]}" 2>/dev/null || true
  rm -rf "$folder"
}
trap finish EXIT

# Gives up on what does not come true in a minute: until_true COMMAND...
until_true() {
  local tries=600
  until "$@" 2>/dev/null; do
    ((tries-- > 0)) || { echo "${0##*/}: waited in vain for: $*" >&2; exit 1; }
    sleep 0.1
  done
}

# Its windows' numbers, once it has any: windows_of PROCESS FILE
windows_of() { until_true find_windows "$@"; }
find_windows() { xdotool search --onlyvisible --pid "$1" >"$2"; }

Xvfb -displayfd 3 -screen 0 1280x1100x24 -nolisten tcp -noreset 3>"$folder/display" 2>/dev/null &
processes+=($!)
until_true test -s "$folder/display"
DISPLAY=:$(cat "$folder/display")
export DISPLAY
