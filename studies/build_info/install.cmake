# `cmake --install`: the program with its data, manual page and completions, and the engine for other
# programs (find_package(gurney)). `cpack` makes a Debian package of each of the two. The program finds
# its data from its own place, so that the folder may be moved.
install(TARGETS gurney RUNTIME DESTINATION bin COMPONENT program)

# The folders of the source tree keep their places, so that jobs find what they name.
foreach(folder equipment groundmotions/records groundmotions/buildings studies/jobs studies/assessment
    studies/hospitals studies/calibration/example)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/ DESTINATION share/gurney/${folder}
    COMPONENT program FILES_MATCHING PATTERN "*.toml" PATTERN "*.csv" PATTERN catalogue EXCLUDE)
endforeach()

# Curves that gurney hospital takes.
foreach(table fragility more_states)
  install(FILES ${PROJECT_SOURCE_DIR}/docs/catalogue/data/${table}.csv
    DESTINATION share/gurney/docs/catalogue/data COMPONENT program)
endforeach()

# The page of the workbench, where ./dev workbench has made it.
install(FILES ${PROJECT_SOURCE_DIR}/build/workbench/workbench.html DESTINATION share/gurney
  COMPONENT program OPTIONAL)

# The license, with the notices of code that is compiled in.
file(READ ${PROJECT_SOURCE_DIR}/LICENSE license)
file(READ ${CMAKE_CURRENT_LIST_DIR}/notices.txt notices)
file(WRITE ${PROJECT_BINARY_DIR}/copyright "${license}${notices}")
foreach(component_of program:gurney development:gurney-dev python:python3-gurney)
  string(REGEX MATCH "^(.*):(.*)$" component_of "${component_of}")
  install(FILES ${PROJECT_BINARY_DIR}/copyright DESTINATION share/doc/${CMAKE_MATCH_2}
    COMPONENT ${CMAKE_MATCH_1})
endforeach()

# Written by the program itself.
install(CODE [[
  foreach(page "help --man:gurney.1" "completion bash:gurney" "completion zsh:_gurney")
    string(REGEX MATCH "^(.*):(.*)$" page "${page}")
    separate_arguments(arguments UNIX_COMMAND "${CMAKE_MATCH_1}")
    execute_process(COMMAND "$<TARGET_FILE:gurney>" ${arguments} COMMAND_ERROR_IS_FATAL ANY
      OUTPUT_FILE "$<TARGET_FILE_DIR:gurney>/manual/${CMAKE_MATCH_2}")
  endforeach()
]] COMPONENT program)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/manual)
install(FILES ${PROJECT_BINARY_DIR}/manual/gurney.1 DESTINATION share/man/man1 COMPONENT program)
install(FILES ${PROJECT_BINARY_DIR}/manual/gurney DESTINATION share/bash-completion/completions
  COMPONENT program)
install(FILES ${PROJECT_BINARY_DIR}/manual/_gurney DESTINATION share/zsh/vendor-completions
  COMPONENT program)

# The Python package, with gurney.simulate where it was built. Debian's Python looks into these folders;
# another Python says where: python3 -c "import sysconfig; print(sysconfig.get_path('platlib'))".
set(GURNEY_PYTHON_FOLDER "" CACHE STRING
  "Folder of Python packages, absolute or below the prefix; empty: those of Debian 12")
if(GURNEY_PYTHON_FOLDER)
  install(CODE "set(GURNEY_PYTHON_FOLDER [[${GURNEY_PYTHON_FOLDER}]])" COMPONENT python)
  install(CODE [[
    if(IS_ABSOLUTE "${GURNEY_PYTHON_FOLDER}")
      file(RELATIVE_PATH GURNEY_PYTHON_FOLDER "${CMAKE_INSTALL_PREFIX}" "${GURNEY_PYTHON_FOLDER}")
    endif()
  ]] COMPONENT python)
else()
  install(CODE [[
    set(GURNEY_PYTHON_FOLDER lib/python3/dist-packages)
    if(CMAKE_INSTALL_PREFIX STREQUAL "/usr/local")
      set(GURNEY_PYTHON_FOLDER lib/python3.11/dist-packages)
    endif()
  ]] COMPONENT python)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/studies/python/gurney DESTINATION "\${GURNEY_PYTHON_FOLDER}"
  COMPONENT python FILES_MATCHING PATTERN "*.py" PATTERN py.typed PATTERN __pycache__ EXCLUDE)
if(TARGET gurney_bindings)
  install(TARGETS gurney_bindings LIBRARY DESTINATION "\${GURNEY_PYTHON_FOLDER}/gurney"
    COMPONENT python OPTIONAL)
endif()

# The engine for other programs: rooms below studies/ are not among them.
set(exported gurney_options)
foreach(line IN LISTS GURNEY_ROOMS)
  string(REGEX MATCH "^(engine|groundmotions|equipment)/[a-z_]+" room "${line}")
  string(REPLACE "/" "_" name "${room}")
  if(room AND TARGET gurney_${name})
    list(APPEND exported gurney_${name})
    set_target_properties(gurney_${name} PROPERTIES EXPORT_NAME ${name})
    list(APPEND ${CMAKE_MATCH_1}_rooms gurney_${name})
  endif()
endforeach()
foreach(group engine groundmotions equipment)
  add_library(gurney_${group} INTERFACE)
  target_link_libraries(gurney_${group} INTERFACE ${${group}_rooms})
  set_target_properties(gurney_${group} PROPERTIES EXPORT_NAME ${group})
  list(APPEND exported gurney_${group})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${group}/ DESTINATION include/gurney/${group}
    COMPONENT development FILES_MATCHING PATTERN "*.h")
endforeach()
target_compile_definitions(gurney_equipment INTERFACE
  $<INSTALL_INTERFACE:GURNEY_DATA_FOLDER="$<INSTALL_PREFIX>/share/gurney">)
set_target_properties(gurney_options PROPERTIES EXPORT_NAME options)
install(TARGETS ${exported} EXPORT gurney ARCHIVE DESTINATION lib/gurney COMPONENT development)
install(EXPORT gurney NAMESPACE gurney:: FILE gurneyTargets.cmake DESTINATION lib/cmake/gurney
  COMPONENT development)

include(CMakePackageConfigHelpers)
# That of the build: the bits of inlined functions are its.
string(REGEX MATCH "^[0-9]+[.][0-9]+" GURNEY_EIGEN_VERSION "${Eigen3_VERSION}")
set(GURNEY_FIND_TOMLPLUSPLUS
  "pkg_check_modules(tomlplusplus REQUIRED QUIET IMPORTED_TARGET tomlplusplus)")
if(NOT tomlplusplus_FOUND OR NOT TARGET PkgConfig::tomlplusplus)
  set(GURNEY_FIND_TOMLPLUSPLUS "find_dependency(tomlplusplus)")
endif()
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/gurneyConfig.cmake.in
  ${PROJECT_BINARY_DIR}/gurneyConfig.cmake INSTALL_DESTINATION lib/cmake/gurney)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/gurneyConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/gurneyConfig.cmake
  ${PROJECT_BINARY_DIR}/gurneyConfigVersion.cmake DESTINATION lib/cmake/gurney
  COMPONENT development)
install(FILES ${CMAKE_CURRENT_LIST_DIR}/bullet.cmake DESTINATION lib/cmake/gurney
  RENAME gurneyBullet.cmake COMPONENT development)

include(${CMAKE_CURRENT_LIST_DIR}/package.cmake)
