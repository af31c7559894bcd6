#!/usr/bin/env bash
# Which Bullet the build takes (studies/build_info/bullet.cmake): any in double precision, by pkg-config
# or by Bullet's own CMake package, and none in single precision. The packages are made up: nothing is
# compiled.
# usage: bullet.sh CMAKE SOURCE_FOLDER
set -uo pipefail
cmake=$1 source=$2
. "$source/tests/system/cli/expect.sh"
unset PKG_CONFIG_PATH CMAKE_PREFIX_PATH

mkdir project
cat > project/CMakeLists.txt << 'CMAKE'
cmake_minimum_required(VERSION 3.25)
project(bullet LANGUAGES NONE)
include(${MODULE})
if(NOT TARGET gurney::bullet)
  message(FATAL_ERROR "${GURNEY_BULLET_PROBLEM}")
endif()
get_target_property(libraries gurney::bullet INTERFACE_LINK_LIBRARIES)
get_target_property(definitions gurney::bullet INTERFACE_COMPILE_DEFINITIONS)
message(STATUS "takes ${GURNEY_BULLET_VERSION} of ${libraries}, ${definitions}")
CMAKE

# pc FOLDER MODULE VERSION FLAGS: a package of pkg-config
pc() {
  mkdir -p "$1"
  printf 'Name: bullet\nDescription: made up\nVersion: %s\nLibs:\nCflags: %s\n' "$3" "$4" > "$1/$2.pc"
}

# own PREFIX DEFINITIONS: a build of one's own
own() {
  mkdir -p "$1"/lib/cmake/bullet "$1/include/bullet"
  touch "$1/include/bullet/btBulletDynamicsCommon.h"
  touch "$1"/lib/lib{LinearMath,BulletCollision,BulletDynamics}.so
  printf 'set(%s "%s")\n' BULLET_FOUND 1 BULLET_DEFINITIONS "$2" BULLET_INCLUDE_DIR include/bullet \
    BULLET_INCLUDE_DIRS include/bullet BULLET_LIBRARY_DIRS lib BULLET_ROOT_DIR "$1" \
    BULLET_VERSION_STRING 4.56 > "$1/lib/cmake/bullet/BulletConfig.cmake"
}

# in_one_line COMMAND...: what it prints, which CMake breaks into lines
# shellcheck disable=SC2317
in_one_line() {
  "$@" 2>&1 | tr -s '\n ' ' '
  return "${PIPESTATUS[0]}"
}

# configure EXIT_CODE TEXT FOLDER OPTION...: with no other packages than those in FOLDER
configure() {
  expect "$1" "$2" in_one_line env PKG_CONFIG_LIBDIR="$folder/$3" "$cmake" -S project -B "build of $3" \
    -DMODULE="$source/studies/build_info/bullet.cmake" "${@:4}"
}

none=-DCMAKE_DISABLE_FIND_PACKAGE_Bullet=ON
own=-DCMAKE_DISABLE_FIND_PACKAGE_Bullet=OFF
double=-DBT_USE_DOUBLE_PRECISION
pc debian bullet-float64 1.23 "$double -I/none"
pc debian bullet 1.22 "-I/none"
configure 0 "takes 1.23 of PkgConfig::gurney_bullet_float64" debian $none

pc double bullet 1.24 "-I/none $double"
configure 0 "takes 1.24 of PkgConfig::gurney_bullet" double $none

pc single bullet 1.25 "-I/none/BT_USE_DOUBLE_PRECISION -DNO_BT_USE_DOUBLE_PRECISION"
configure 1 "single precision" single $none
for text in "pkg-config bullet 1.25" "libbullet-dev" "bullet-dp" "USE_DOUBLE_PRECISION=ON"; do
  grep -qF -- "$text" stdout || complain "a Bullet in single precision: the message lacks $text"
done
# Another one, in the same build folder.
pc single bullet 1.26 "$double"
configure 0 "takes 1.26 of" single $none

mkdir nothing
configure 1 "there is none here" nothing $none
own "$folder/own single" ""
configure 1 "single precision" nothing $own "-DCMAKE_PREFIX_PATH=$folder/own single"
grep -qF "find_package(Bullet) 4.56" stdout || complain "the message does not name find_package(Bullet)"
own "$folder/own double" "$double"
configure 0 "takes 4.56 of $folder/own double/lib/libBulletDynamics.so" nothing $own \
  "-DCMAKE_PREFIX_PATH=$folder/own double"
grep -qF ", BT_USE_DOUBLE_PRECISION" stdout || complain "programs are not compiled with Bullet's precision"
rm "$folder/own double/lib/libLinearMath.so" && rm -r "build of nothing"
configure 1 "not there" nothing $own "-DCMAKE_PREFIX_PATH=$folder/own double"

[ "$failures" -eq 0 ] && echo "any Bullet in double precision"
exit $((failures > 0))
