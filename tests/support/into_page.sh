# into_page PAGE NAME: what comes on standard input replaces what stands in the page between the lines <!-- NAME -->
# and <!-- end of NAME -->. Sourced.
into_page() {
  local page=$1 name=$2 text
  text=$(mktemp)
  grep -qxF "<!-- $name -->" "$page" && grep -qxF "<!-- end of $name -->" "$page" || {
    printf '%s has no place for %s\n' "$page" "$name" >&2
    return 1
  }
  {
    sed "/^<!-- $name -->\$/q" "$page"
    printf '\n'
    cat
    printf '\n'
    sed -n "/^<!-- end of $name -->\$/,\$p" "$page"
  } >"$text"
  cat "$text" >"$page"
  rm "$text"
}
