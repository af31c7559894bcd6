# For the tests of the command line: run in a folder of their own, count failures.

complain() {
  printf 'FAILED: %s\n--- stdout\n%s\n--- stderr\n%s\n' "$1" "$(head -c 2000 stdout)" "$(head -c 2000 stderr)"
  failures=$((failures + 1))
}

# expect CODE TEXT COMMAND...: it exits with CODE and says TEXT somewhere
expect() {
  local code=$1 text=$2
  shift 2
  "$@" > stdout 2> stderr
  local got=$?
  [ "$got" -eq "$code" ] || complain "exit code $got instead of $code: $*"
  grep -qF -- "$text" stdout stderr || complain "does not say '$text': $*"
}

failures=0
folder=$(mktemp -d "${TMPDIR:-/tmp}/gurney cli XXXXXX") || exit 1
trap 'chmod -R u+w "$folder"; rm -rf "$folder"' EXIT
cd "$folder" || exit 1
