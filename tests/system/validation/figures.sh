#!/usr/bin/env bash
# A study of docs/validation.md from its job to its figure. Exit code 77: python3-h5py is missing.
# usage: figures.sh GURNEY SOURCE_FOLDER
set -euo pipefail
python3=/usr/bin/python3
"$python3" -c 'import h5py, pandas' 2> /dev/null || exit 77
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"$1" run "$2/studies/jobs/validation_half_locked.toml" -o validation_half_locked.h5 > /dev/null 2>&1
PYTHONDONTWRITEBYTECODE=1 "$python3" "$2/docs/validation/figures.py" . . half_locked
grep -q '<svg' validation_half_locked.svg
circles=$(grep -c '<circle' validation_half_locked.svg)
# Two periods x four amplitudes x locked and free x three numbers of cycles, and four of the legend.
[ "$circles" -eq 52 ] || { echo "$circles points instead of 52"; exit 1; }
