# The compiled part of the Python package: one run in memory. Built where pybind11-dev and python3-dev
# are installed. In the build folder python/gurney is the package with links to its sources.
option(GURNEY_BINDINGS "Build the module of Python where pybind11 and Python's headers are" ON)
find_program(GURNEY_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(GURNEY_PYTHON python3)

add_custom_target(product DEPENDS gurney)
file(GLOB modules CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/../python/gurney/*.py
  ${CMAKE_CURRENT_LIST_DIR}/../python/gurney/py.typed)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/python/gurney)
file(GLOB links ${PROJECT_BINARY_DIR}/python/gurney/*.py)  # some may be of files that are gone
file(REMOVE ${links})
file(WRITE ${PROJECT_BINARY_DIR}/python/gurney/source_folder "${PROJECT_SOURCE_DIR}\n")
foreach(module IN LISTS modules)
  get_filename_component(name ${module} NAME)
  file(CREATE_LINK ${module} ${PROJECT_BINARY_DIR}/python/gurney/${name} SYMBOLIC)
endforeach()

if(GURNEY_BINDINGS AND GURNEY_PYTHON)
  set(Python_EXECUTABLE ${GURNEY_PYTHON})
  find_package(Python 3.11 QUIET COMPONENTS Interpreter Development.Module)
  set(PYBIND11_NOPYTHON ON)
  find_package(pybind11 2.10 QUIET CONFIG)
endif()
if(NOT TARGET Python::Module OR NOT TARGET pybind11::headers)
  message(STATUS "gurney.simulate for Python is not built: it needs python3-dev and pybind11-dev")
  return()
endif()
file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*.cpp)
add_library(gurney_bindings MODULE ${sources})
target_link_libraries(gurney_bindings PRIVATE Python::Module pybind11::headers
  gurney_engine_run gurney_studies_prepare gurney_studies_results
  gurney_studies_analysis ${CMAKE_DL_LIBS})
target_compile_options(gurney_bindings PRIVATE ${GURNEY_LIGHT_OPTIONS})
set_target_properties(gurney_bindings PROPERTIES PREFIX "" OUTPUT_NAME _engine
  SUFFIX ".${Python_SOABI}.so" LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/python/gurney)
add_dependencies(product gurney_bindings)
