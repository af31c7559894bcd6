#!/usr/bin/env bash
# Runs every command that README.md and docs show in a ```sh block, in a copy of what a user has.
# Those of docs/tutorial.md and docs/python.md are run by tests/system/python/tutorial_page.py.
# Studies of twenty synthetic records or more have three here: the commands are tested, not the
# numbers. ./dev run and ./dev test would call this test again: of ./dev only the syntax and the
# command's name are checked.
# usage: documented_commands.sh GURNEY SOURCE_FOLDER
set -uo pipefail
program=$1
source=$2
folder=$(mktemp -d "${TMPDIR:-/tmp}/gurney docs XXXXXX")
trap 'rm -rf "$folder"' EXIT
cp -r "$source"/{studies,equipment,groundmotions,dev} "$folder" || exit 1
cd "$folder" || exit 1
sed -i -E 's/^(synthetic_records =) [2-9][0-9]+/\1 3/' studies/jobs/*.toml || exit 1
PATH=$(dirname "$program"):$PATH
bash -n dev || exit 1
failures=0 count=0

while IFS= read -r -d '' page; do
  while IFS= read -r command; do
    count=$((count + 1))
    case "$command" in
      ./dev\ *)
        name=${command#./dev }
        ./dev help | grep -q "^./dev ${name%% *} " && continue
        output="./dev help does not know it" ;;
      gurney\ workbench*)
        output=$(bash -euo pipefail -c "$command" 2>&1) && continue
        [ -e "$source/build/workbench/workbench.html" ] || continue ;;  # ./dev workbench has not made it
      *)
        output=$(bash -euo pipefail -c "$command" 2>&1) && continue ;;
    esac
    printf 'FAILED: %s: %s\n%s\n' "${page#"$source"/}" "$command" "$output"
    failures=$((failures + 1))
  done < <(awk '/^```sh$/ {inside = 1; next} /^```/ {inside = 0}
    inside && sub(/\\$/, "") {begun = begun $0; next}
    inside && NF && !/^#/ {print begun $0; begun = ""}' "$page")
done < <(find "$source/README.md" "$source/docs" -name '*.md' ! -path "$source/docs/tutorial.md" \
  ! -path "$source/docs/python.md" -print0)

[ "$count" -gt 0 ] || { echo "no page shows a command"; exit 1; }
[ "$failures" -eq 0 ] && echo "$count commands work"
exit $((failures > 0))
