# What demo.sh, test.sh and .ci/run share: the packages that a build needs, and the release build. Sourced, with
# the project's folder as the current one.

packages=(g++ cmake ninja-build libglm-dev libpng-dev zlib1g-dev libtomlplusplus-dev libcli11-dev
  nlohmann-json3-dev libhwy-dev catch2)
# Displays, each of which is optional, and what people do at one.
display_packages=(libsdl2-dev)
display_test_packages=("${display_packages[@]}" xvfb xdotool imagemagick strace)
# VNC and the browser, which no script but .ci/run installs: they are large.
vnc_test_packages=(libvncserver-dev gvncviewer novnc websockify chromium)

fail() {
  printf '%s: %s\n' "${0##*/}" "$1" >&2
  exit 1
}

# Reads the arguments that both scripts have; the first parameter is the text of --help.
read_arguments() {
  local help=$1 argument
  shift
  install=yes
  for argument in "$@"; do
    case $argument in
      --no-install) install=no ;;
      -h | --help)
        printf '%s\n' "$help"
        exit 0
        ;;
      *) fail "unknown argument $argument; --help tells what is understood" ;;
    esac
  done
}

# Installs those of the packages named that are missing, or says which they are and ends.
require_packages() {
  local status name missing=()
  local -A have=()
  if ! command -v dpkg-query >/dev/null; then
    printf 'This is not a Debian system, so nothing is installed. The build needs what Debian calls: %s\n' "$*"
    return
  fi
  while read -r status name; do
    [[ $status != installed ]] || have[$name]=yes
  done < <(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null)
  for name in "$@"; do
    [[ ${have[$name]:-} ]] || missing+=("$name")
  done
  ((${#missing[@]})) || return 0

  local as_root=()
  ((EUID == 0)) || as_root=(sudo)
  local command="${as_root[*]} apt-get install --no-install-recommends ${missing[*]}"
  command=${command# }
  if [[ $install == no ]]; then
    fail "these packages are missing: ${missing[*]}
Install them with:
  $command"
  fi
  if ((EUID != 0)) && ! command -v sudo >/dev/null; then
    fail "these packages are missing, and there is no sudo to install them with: ${missing[*]}
As root, run:
  ${command#sudo }"
  fi

  printf 'Installing with apt: %s\n' "${missing[*]}"
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y)
  # The lists may never have been fetched, or be older than what the mirror still has.
  if ! apt-cache show "${missing[@]}" >/dev/null 2>&1 ||
    ! "${apt[@]}" install --no-install-recommends "${missing[@]}"; then
    "${apt[@]}" update || fail "apt-get update failed"
    "${apt[@]}" install --no-install-recommends "${missing[@]}" || fail "these packages could not be installed: ${missing[*]}"
  fi
}

# require_version NAME LEAST FOUND
require_version() {
  printf '%s\n%s\n' "$2" "$3" | sort -V -C ||
    fail "$1 $2 or newer is needed, and this is $3 (Debian 12 has what is needed)"
}

# Configures and builds the targets named in build/release.
build_release() {
  local log=build/release/configure.log version fresh=()
  version=$(cmake --version) || fail "cmake does not run"
  version=${version%%$'\n'*}
  require_version cmake 3.25 "${version##* }"
  [[ ${CXX:-} ]] || require_version g++ 12 "$(g++ -dumpfullversion)"

  mkdir -p build/release || fail "the folder build/release cannot be made here"
  # A folder that was copied or moved brings a cache that names its old place.
  if [[ -f build/release/CMakeCache.txt ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" build/release/CMakeCache.txt; then
    fresh=(--fresh)
  fi
  if ! cmake --preset release "${fresh[@]}" >"$log" 2>&1; then
    cat "$log" >&2
    fail "cmake could not configure the build (above, and in $PWD/$log)"
  fi
  cmake --build build/release --target "$@" || fail "the build failed (above)"
}
