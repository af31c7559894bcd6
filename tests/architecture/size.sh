#!/usr/bin/env bash
# size.sh [ROOT]: lines and files of each room of the program, and of what stands beside it. Blank
# lines and comments count; folders of builds and runs do not.
set -euo pipefail
cd "${1:-$(dirname "$0")/../..}"
{
  sed -n '/GURNEY_LIBRARIES/q; s|^  "\([a-z_/]*\):.*|room \1|p' tests/architecture/rooms.cmake
  find engine groundmotions equipment studies tests docs dev .ci README.md CHANGELOG.md CMakeLists.txt \
    -type f ! -path '*/__pycache__/*' -exec wc -l {} + | grep -v ' total$'
} | awk '
  # Innermost room of a path, or its folder.
  function room_of(path,   folder) {
    folder = path
    while (sub("/[^/]*$", "", folder)) if (folder in is_room) return folder
    sub("/[^/]*$", "", path)
    return path
  }
  function count(part, lines) { sum[part] += lines; files[part]++ }
  function row(part) { printf "%-34s %7d lines %5d files\n", part, sum[part], files[part] }
  $1 == "room" { rooms[++n] = $2; is_room[$2] = 1; next }
  { tests = $2 ~ "^tests/"; product = $2 ~ "^(engine|groundmotions|equipment|studies)/" }
  product && /[.](h|cpp)$/ { count(room_of($2), $1); count("C++ of the product", $1); next }
  product && /[.]py$/ { count("Python of the product", $1); next }
  product && /[.](js|css|html)$/ { count("JavaScript, CSS and HTML", $1); next }
  /[.]toml$/ && product { count("data (TOML)", $1); next }
  tests && /[.](h|cpp)$/ { count("C++ of the tests", $1); next }
  tests && /[.](py|sh)$/ { count("Python and shell of the tests", $1); next }
  /(CMakeLists[.]txt|[.]cmake|^ *[0-9]+ (dev|[.]ci\/run))$/ { count("build (CMake, dev, CI)", $1); next }
  /[.]md$/ { count("pages (Markdown)", $1) }
  END {
    for (i = 1; i <= n; i++) row(rooms[i])
    print ""
    row("C++ of the product")
    row("Python of the product")
    row("JavaScript, CSS and HTML")
    row("data (TOML)")
    row("C++ of the tests")
    row("Python and shell of the tests")
    row("build (CMake, dev, CI)")
    row("pages (Markdown)")
  }'
