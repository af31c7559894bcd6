#!/usr/bin/env bash
# ./dev release --check: the versions of all files agree, a changed tree and a differing version are refused,
# and each thing that only the owner can fill is in the list of docs/contributing.md.
# usage: release.sh SOURCE_FOLDER
set -uo pipefail
source=$1
. "$source/tests/system/cli/expect.sh"
command -v git > /dev/null || { echo "skipped: git is not here"; exit 77; }
export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_SYSTEM=/dev/null
unset GIT_DIR GIT_WORK_TREE GIT_INDEX_FILE

versions=(CHANGELOG.md CITATION.cff pyproject.toml docs/cite.md docs/packaging/conda/meta.yaml
  docs/packaging/spack/packages/gurney/package.py)
owned=(.github/SECURITY.md docs/paper.md docs/paper.bib docs/site/mkdocs.yml studies/build_info/package.cmake)
mkdir clone
for file in dev CMakeLists.txt docs/contributing.md "${versions[@]}" "${owned[@]}"; do
  mkdir -p "clone/$(dirname "$file")" && cp "$source/$file" "clone/$file" || complain "$file is not there"
done
as_test() { git -C clone -c user.name=test -c user.email=test@example.org "$@"; }
as_test init -q && as_test add -A && as_test commit -qm "A release"

expect 0 "versions agree" clone/dev release --check
cp stdout asked
for name in $(grep -oE 'OWNER-[A-Z0-9]+' asked | sort -u); do
  grep -qF "| \`$name\` |" "$source/docs/contributing.md" || complain "docs/contributing.md does not list $name"
done
for name in $(grep -oE '^\| `OWNER-[A-Z0-9]+' "$source/docs/contributing.md" | tr -d '|` '); do
  grep -qF "$name" asked || complain "docs/contributing.md lists $name, which no file asks for"
done

echo >> clone/dev
expect 1 "changes that are not committed" clone/dev release --check
as_test checkout -q dev
for file in "${versions[@]}"; do
  cp "clone/$file" kept
  sed -i 's/[0-9]\+\.[0-9]\+\.[0-9]\+/9.8.7/' "clone/$file"
  [ "$file" != CITATION.cff ] || sed -i 's/^version: .*/version: 9.8.7/' "clone/$file"
  expect 1 "$file has the version '9.8.7'" clone/dev release --check
  cp kept "clone/$file"
done
rm clone/CITATION.cff
expect 1 "CITATION.cff has the version ''" clone/dev release --check
expect 1 "release knows --check only" clone/dev release

[ "$failures" -eq 0 ] && echo "a release is checked"
exit $((failures > 0))
