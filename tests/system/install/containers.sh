#!/usr/bin/env bash
# The container recipes: each library that the program loads is in the list of packages of the final
# image, which has no compiler; what they copy is what the installation makes. No image is built.
# Skipped (77) but on Debian 12.
# usage: containers.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1 source=$2
. "$source/tests/system/cli/expect.sh"
[ "$(. /etc/os-release && echo "$ID$VERSION_ID")" = debian12 ] || { echo "skipped: no Debian 12"; exit 77; }
for tool in readelf ldd dpkg; do
  command -v "$tool" > /dev/null || { echo "skipped: $tool is not here"; exit 77; }
done
touch stdout stderr

for recipe in Dockerfile apptainer.def; do
  # The packages of the last stage.
  grep -oE '^ +lib[a-z0-9+.-]+' "$source/$recipe" | tr -d ' ' > packages
  grep -qE -- '-dev$' packages && complain "$recipe: headers in the final image"
  for library in $(readelf -d "$gurney" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p'); do
    path=$(ldd "$gurney" | awk -v library="$library" '$1 == library {print $3}')
    package=$(dpkg -S "*${path##*/}" 2> /dev/null |
      awk -v path="${path#/usr}" '$2 == path || $2 == "/usr" path {sub(":.*", ""); print; exit}')
    case "$library $package" in
      *" libc6" | ld-linux*) ;;
      *" ") complain "no package has $library" ;;
      *) grep -qxF -- "$package" packages || complain "$recipe lacks $package, which has $library" ;;
    esac
  done
  grep -qxF librsvg2-2 packages || complain "$recipe lacks librsvg2-2: no PDF and PNG"
  for step in "./dev setup" "./dev install" "GURNEY_CPU" "/usr/local/bin/gurney" "/usr/local/share" "debian:12-slim" \
      "gurney verify skid_to_roll"; do
    grep -qF -- "$step" "$source/$recipe" || complain "$recipe lacks $step"
  done
done
expect 0 "skid_to_roll" "$gurney" verify skid_to_roll

[ "$failures" -eq 0 ] && echo "container recipes have what the program loads"
exit $((failures > 0))
