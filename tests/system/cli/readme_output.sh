#!/usr/bin/env bash
# What README.md shows of the main job's output is what the program prints.
# usage: readme_output.sh GURNEY SOURCE_FOLDER
set -euo pipefail
program=$1
source=$2
folder=$(mktemp -d "${TMPDIR:-/tmp}/gurney readme XXXXXX")
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"$program" run "$source/studies/jobs/icu_ventilator_shake.toml" > printed
awk '/^```text$/ {blocks++; inside = blocks == 1; next} /^```/ {inside = 0} inside' \
  "$source/README.md" > shown
lines=0
while IFS= read -r line; do
  case "$line" in '' | '  ...') continue ;; esac
  grep -qxF -- "$line" printed || { printf 'README shows, but gurney does not print:\n%s\n' "$line"; exit 1; }
  lines=$((lines + 1))
done < shown
[ "$lines" -gt 10 ] || { echo "README shows only $lines lines of output"; exit 1; }
