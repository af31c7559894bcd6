#!/usr/bin/env bash
# The Debian package, installed by dpkg and run in a root folder that holds nothing but what the
# package depends on. It is made from the packages of this machine, without a network. Where no such
# root can be entered, the unpacked package is run. Skipped (77) where nothing makes packages.
# usage: package.sh GURNEY SOURCE_FOLDER BUILD_FOLDER CPACK
set -uo pipefail
gurney=$1 source=$2 build=$3 cpack=$4
. "$source/tests/system/cli/expect.sh"
unset GURNEY_DATA
for tool in "$cpack" dpkg dpkg-shlibdeps apt-cache file; do
  command -v "$tool" > /dev/null || { echo "skipped: $tool is not here"; exit 77; }
done

expect 0 "gurney_" "$cpack" --config "$build/CPackConfig.cmake" -B "$folder/packages"
package=$(echo packages/gurney_*.deb)
compgen -G "packages/gurney-dev_*.deb" > stdout || complain "no package of the engine"
if compgen -G "$build/python/gurney/_engine.*.so" > /dev/null; then
  dpkg-deb -c packages/python3-gurney_*.deb > stdout
  grep -q "usr/lib/python3/dist-packages/gurney/_engine\..*so" stdout || complain "no module in python3-gurney"
  grep -q "usr/lib/python3/dist-packages/gurney/simulation.py" stdout || complain "no package in python3-gurney"
fi
for each in packages/*.deb; do
  name=$(dpkg-deb -f "$each" Package)
  dpkg-deb --fsys-tarfile "$each" | tar -xO "./usr/share/doc/$name/copyright" > stdout 2> stderr
  for notice in "Gurney" "CLI11" "JSON for Modern C++" "toml++" "Boost Software License" "Mozilla Public" "Victor Zverovich"; do
    grep -qF "$notice" stdout || complain "$name: no notice of $notice in its file copyright"
  done
done
dpkg-deb -f "$package" Depends > stdout
for library in libbullet libhdf5 libfmt libtomlplusplus; do
  grep -q "$library" stdout || complain "the package does not depend on $library"
done
dpkg-deb -f "$package" Recommends > stdout
grep -q librsvg2-2 stdout || complain "the package does not recommend librsvg2-2"
[ "$failures" -eq 0 ] || exit 1

database() {  # ROOT: an empty one
  mkdir -p "$1"/var/lib/dpkg/{info,updates} "$1/tmp" "$1/proc"
  : > "$1/var/lib/dpkg/status"
  echo 1 > "$1/var/lib/dpkg/info/format"
}

# Names of the packages that the package needs, with those that they need.
needed() {
  dpkg-deb -f "$package" Depends | tr ',' '\n' | awk '{print $1}' |
    xargs -r apt-cache depends --recurse --installed --no-recommends --no-suggests --no-conflicts \
      --no-breaks --no-replaces --no-enhances | grep '^[a-z]' | sort -u |
    xargs -r dpkg-query -W -f='${db:Status-Status} ${binary:Package}\n' 2> /dev/null |
    awk '$1 == "installed" {print $2}'
}

make_root() {  # root/: the files and the database of what is needed
  local packages
  mapfile -t packages < <(needed)
  database root
  mkdir -p root/usr/{bin,sbin,lib,lib64}
  ln -s usr/bin usr/sbin usr/lib usr/lib64 root/
  dpkg-query -L "${packages[@]}" | grep '^/.' | grep -v '^/usr/share/\(doc\|man\|locale\|info\)/' |
    sed -E 's#^/(bin|sbin|lib|lib64)/#/usr/\1/#' | sort -u |
    grep -vxE '/(bin|sbin|lib|lib64|usr|usr/(bin|sbin|lib|lib64))' |
    tar -C / -c --no-recursion --ignore-failed-read -T - 2> /dev/null | tar -C root -x
  dpkg-query -s "${packages[@]}" > root/var/lib/dpkg/status
  local name
  for name in "${packages[@]}"; do cp "/var/lib/dpkg/info/$name.list" root/var/lib/dpkg/info/; done
}

# shellcheck disable=SC2317
inside() { unshare --mount sh -c 'mount --rbind /proc root/proc && exec chroot root "$@"' sh "$@"; }

job=/usr/share/gurney/studies/jobs/icu_ventilator_shake.toml
database empty
if [ "$(id -u)" -ne 0 ] || ! unshare --mount true 2> /dev/null; then
  echo "no root here: the unpacked package is run, its dependencies are those of this machine"
  dpkg-deb -x "$package" root
  mkdir -p root/tmp
  run=(root/usr/bin/gurney)
  job=root$job results=root/tmp/x.h5
else
  expect 1 "depends on libbullet" dpkg --root=empty --log=/dev/null -i "$package"
  make_root
  expect 0 "Setting up gurney" dpkg --root=root --log=/dev/null -i "$package"
  run=(inside /usr/bin/gurney)
  results=/tmp/x.h5
  expect 0 "SVG only" "${run[@]}" doctor
fi
expect 0 "installed with the program" "${run[@]}" doctor
expect 0 "results" "${run[@]}" run "$job" -o "$results" --no-figure
expect 0 "results" "$gurney" run "$source/studies/jobs/icu_ventilator_shake.toml" -o here.h5 --no-figure
cmp here.h5 root/tmp/x.h5 || complain "the package gives other results"
expect 0 "rest of the page" sh -c 'zcat -f root/usr/share/man/man1/gurney.1 | grep -c "^.SS gurney" && echo rest of the page'

[ "$failures" -eq 0 ] && echo "packaged, installed and run"
exit $((failures > 0))
