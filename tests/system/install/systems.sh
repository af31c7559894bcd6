#!/usr/bin/env bash
# What ./dev setup asks of the package managers of Debian, Ubuntu, Fedora, Arch and an unknown system. The
# managers are made up: they write down what they are asked, and know what the test says.
# usage: systems.sh SOURCE_FOLDER
set -uo pipefail
source=$1
. "$source/tests/system/cli/expect.sh"
mkdir tools log
for tool in awk bash cat dirname env id sort; do ln -s "$(command -v "$tool")" tools/; done
export LOG=$folder/log/asked

# tool FOLDER NAME BODY: a program, which first writes down its command line
tool() {
  mkdir -p "$1"
  printf '#!/usr/bin/env bash\nprintf "%%s\\n" "%s $*" >> "$LOG"\n%s\n' "$2" "$3" > "$1/$2"
  chmod +x "$1/$2"
}

# setup CODE TEXT SYSTEM ID...: ./dev setup with the tools of SYSTEM, where os-release has ID...
setup() {
  printf 'ID=%s\nID_LIKE="%s"\n' "$3" "${*:4}" > os-release
  : > "$LOG"
  tool "$3" sudo '"$@"'
  expect "$1" "$2" env PATH="$folder/$3:$folder/tools" GURNEY_OS_RELEASE="$folder/os-release" \
    bash "$source/dev" setup
}

asked() { grep -qxF -- "$1" "$LOG" || complain "not asked: $1, but: $(cat "$LOG")"; }
not_asked() { ! grep -qF -- "$1" "$LOG" || complain "asked: $1"; }

# Debian: only what is missing, in the order of ./dev.
known='case "${*: -1}" in ninja-build | libfmt-dev) exit 1 ;; *) echo -n installed ;; esac'
for system in debian ubuntu; do
  tool $system dpkg-query "$known"
  tool $system apt-get ""
  setup 0 "dev: installing libfmt-dev ninja-build" $system debian
  [ "$(wc -l < stdout)" -eq 1 ] || complain "$system: more than one line"
  asked "apt-get update -qq"
  asked "apt-get install -y -qq --no-install-recommends libfmt-dev ninja-build"
done
tool debian dpkg-query 'echo -n installed'
: > "$LOG"
env PATH="$folder/debian:$folder/tools" GURNEY_OS_RELEASE="$folder/os-release" bash "$source/dev" setup > stdout 2> stderr ||
  complain "fails though nothing is missing"
[ ! -s stdout ] && [ ! -s stderr ] || complain "says something though nothing is missing"
not_asked apt-get

tool fedora rpm '[ "$3" = cmake ]'
tool fedora dnf 'if [ "$2" = repoquery ] && [ "${*: -1}" != Random123-devel ]; then echo "${*: -1}"; fi'
setup 0 "docs/install.md): libbullet-dev librandom123-dev (Random123-devel) librapidcheck-dev" fedora
asked "dnf install -y -q --setopt=install_weak_deps=False boost-devel cairo-devel cli11-devel eigen3-devel \
fast_float-devel fmt-devel gcc-c++ git gmock-devel google-benchmark-devel gtest-devel hdf5-devel json-devel librsvg2-devel \
ninja-build openssl-devel pkgconf-pkg-config tomlplusplus-devel"

tool arch pacman '[ "$1" != -T ] || [ "$2" = cmake ]'
setup 0 "dev: installing benchmark boost bullet-dp" arch
asked "pacman -S --noconfirm --needed benchmark boost bullet-dp cairo cli11 eigen fast_float fmt gcc git gtest hdf5 librsvg \
ninja nlohmann-json openssl pkgconf random123 rapidcheck tomlplusplus"
mv arch manjaro
setup 0 "dev: installing benchmark boost bullet-dp" manjaro arch

# Neither a known name nor dpkg: says what is needed, and goes on.
setup 0 "must be here: cmake g++ git" gentoo

# The table has every package of ./dev.
"$source/dev" packages > stdout 2> stderr || complain "./dev packages fails"
for package in $(sed -n '/_packages=($/,/^)/s/^  //p' "$source/dev"); do
  grep -qF "| \`$package\` |" stdout || complain "the table of ./dev lacks $package"
done

[ "$failures" -eq 0 ] && echo "packages of every system"
exit $((failures > 0))
