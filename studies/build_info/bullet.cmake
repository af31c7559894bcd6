# The double-precision Bullet as gurney::bullet, for the build of the project and, installed beside
# gurneyConfig.cmake, for programs that embed the engine. Asks in this order, and takes the first that is
# compiled with BT_USE_DOUBLE_PRECISION:
#   pkg-config bullet-float64   Debian, Ubuntu, conda-forge
#   pkg-config bullet           Arch (bullet-dp), a build of one's own
#   find_package(Bullet)        a build of one's own without pkg-config
# Sets GURNEY_BULLET_VERSION; where there is none, GURNEY_BULLET_PROBLEM says what to do.
find_package(PkgConfig)
set(GURNEY_BULLET_VERSION "")
set(GURNEY_BULLET_PROBLEM "")
set(gurney_bullet_single "")
# A part of its flags, not of a path in them.
set(gurney_bullet_double "(^|;)(-D)?BT_USE_DOUBLE_PRECISION(=1)?($|;)")

foreach(gurney_module bullet-float64 bullet)
  if(PKG_CONFIG_FOUND AND NOT TARGET gurney::bullet)
    string(REPLACE "-" "_" gurney_prefix "gurney_${gurney_module}")
    pkg_check_modules(${gurney_prefix} QUIET IMPORTED_TARGET ${gurney_module})
    if(${gurney_prefix}_FOUND AND "${${gurney_prefix}_CFLAGS_OTHER}" MATCHES "${gurney_bullet_double}")
      add_library(gurney::bullet INTERFACE IMPORTED)
      target_link_libraries(gurney::bullet INTERFACE PkgConfig::${gurney_prefix})
      set(GURNEY_BULLET_VERSION ${${gurney_prefix}_VERSION})
    elseif(${gurney_prefix}_FOUND)
      list(APPEND gurney_bullet_single "pkg-config ${gurney_module} ${${gurney_prefix}_VERSION}")
      # Another may be there when the build is configured again.
      unset(__pkg_config_checked_${gurney_prefix} CACHE)
    endif()
  endif()
endforeach()

# Bullet's own package names folders and libraries relative to its root, and no targets.
if(NOT TARGET gurney::bullet)
  find_package(Bullet QUIET CONFIG CONFIGS BulletConfig-float64.cmake BulletConfig.cmake)
  if(Bullet_FOUND AND "${BULLET_DEFINITIONS}" MATCHES "${gurney_bullet_double}")
    set(gurney_bullet_libraries "")
    foreach(gurney_name BulletDynamics BulletCollision LinearMath)
      find_library(GURNEY_${gurney_name} NAMES ${gurney_name}-float64 ${gurney_name} NO_DEFAULT_PATH
        PATHS ${BULLET_LIBRARY_DIRS} ${BULLET_ROOT_DIR}/${BULLET_LIBRARY_DIRS})
      mark_as_advanced(GURNEY_${gurney_name})
      list(APPEND gurney_bullet_libraries ${GURNEY_${gurney_name}})
    endforeach()
    find_path(GURNEY_BULLET_HEADERS btBulletDynamicsCommon.h NO_DEFAULT_PATH
      PATHS ${BULLET_INCLUDE_DIRS} ${BULLET_ROOT_DIR}/${BULLET_INCLUDE_DIR})
    mark_as_advanced(GURNEY_BULLET_HEADERS)
    if(GURNEY_BULLET_HEADERS AND NOT "${gurney_bullet_libraries}" MATCHES "NOTFOUND")
      add_library(gurney::bullet INTERFACE IMPORTED)
      target_include_directories(gurney::bullet INTERFACE ${GURNEY_BULLET_HEADERS})
      target_compile_definitions(gurney::bullet INTERFACE BT_USE_DOUBLE_PRECISION)
      target_link_libraries(gurney::bullet INTERFACE ${gurney_bullet_libraries})
      set(GURNEY_BULLET_VERSION ${BULLET_VERSION_STRING})
    else()
      string(APPEND GURNEY_BULLET_PROBLEM
        "${Bullet_DIR} is of a double-precision Bullet, but its headers or libraries are not there. ")
    endif()
  elseif(Bullet_FOUND)
    list(APPEND gurney_bullet_single "find_package(Bullet) ${BULLET_VERSION_STRING} in ${Bullet_DIR}")
    unset(Bullet_DIR CACHE)
  endif()
endif()

if(NOT TARGET gurney::bullet)
  if(gurney_bullet_single)
    string(REPLACE ";" ", " gurney_bullet_single "${gurney_bullet_single}")
    string(APPEND GURNEY_BULLET_PROBLEM
      "Gurney needs Bullet in double precision; that of this system is in single precision: no "
      "BT_USE_DOUBLE_PRECISION in its flags (${gurney_bullet_single}).")
  else()
    string(APPEND GURNEY_BULLET_PROBLEM "Gurney needs Bullet in double precision; there is none here.")
  endif()
  string(APPEND GURNEY_BULLET_PROBLEM "\nDebian, Ubuntu: install libbullet-dev and pkg-config. Arch: install bullet-dp."
    "\nElsewhere: build Bullet's sources with\n  cmake -S bullet3 -B bullet3/build -DUSE_DOUBLE_PRECISION=ON "
    "-DBUILD_SHARED_LIBS=ON -DCMAKE_BUILD_TYPE=Release -DBUILD_BULLET2_DEMOS=OFF -DBUILD_CPU_DEMOS=OFF "
    "-DBUILD_OPENGL3_DEMOS=OFF -DBUILD_EXTRAS=OFF -DBUILD_UNIT_TESTS=OFF -DBUILD_PYBULLET=OFF "
    "-DCMAKE_INSTALL_PREFIX=PREFIX\ninstall it, and configure again with -DCMAKE_PREFIX_PATH=PREFIX.")
endif()
