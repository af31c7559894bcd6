# `cpack`: gurney, which runs, gurney-dev, the engine for other programs, and python3-gurney.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME gurney)
set(CPACK_PACKAGE_VENDOR "the Gurney developers")
# OWNER-CONTACT stands here once there is one.
set(CPACK_PACKAGE_CONTACT "the Gurney developers <gurney@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "seismic response of hospital equipment on casters")
set(CPACK_PACKAGE_DESCRIPTION "Gurney simulates items on casters, alone or in a furnished room, under \
earthquake floor motion, runs studies of thousands of cases and fits fragility functions. This package \
is built for the CPU class ${GURNEY_CPU_CLASS}.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ
  GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program development python)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME gurney)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
# Loaded when the first figure is written as PDF or PNG (studies/picture/rendering.cpp).
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS librsvg2-2)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME gurney-dev)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Headers and static libraries of the engine, with \
find_package(gurney) for CMake: gurney::engine, gurney::groundmotions, gurney::equipment.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "gurney (= ${PROJECT_VERSION}), libbullet-dev, \
libeigen3-dev, libfmt-dev, libssl-dev, libtomlplusplus-dev, pkg-config")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-gurney)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "The Python package: results as data frames, and gurney.simulate, \
which runs items in memory.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "gurney (= ${PROJECT_VERSION}), python3 (>= 3.11), \
python3 (<< 3.12), python3-h5py, python3-pandas")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-xarray, python3-matplotlib")
include(CPack)
