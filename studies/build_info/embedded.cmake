# gurney_embed(room FILE...): the header embedded/NAME.h of the room, with the text of
# each file as `embedded::NAME`, NAME being that of the file with _ for other characters. It is made
# again when the file changes. Called after gurney_room(), whose target it takes. The target
# gurney_texts makes the headers of all rooms, for programs that read the sources without a build.
add_custom_target(gurney_texts)

function(gurney_embed room)
  string(REPLACE "/" "_" target "gurney_${room}")
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/texts/${target})
  foreach(file IN LISTS ARGN)
    get_filename_component(name ${file} NAME)
    string(REGEX REPLACE "[^A-Za-z0-9]" "_" name ${name})
    set(source ${PROJECT_SOURCE_DIR}/${room}/${file})
    set(header ${folder}/embedded/${name}.h)
    add_custom_command(OUTPUT ${header}
      COMMAND ${CMAKE_COMMAND} -DSOURCE=${source} -DNAME=${name} -DOUTPUT=${header}
        -P ${PROJECT_SOURCE_DIR}/studies/build_info/write_embedded.cmake
      DEPENDS ${source} ${PROJECT_SOURCE_DIR}/studies/build_info/write_embedded.cmake VERBATIM)
    target_sources(${target} PRIVATE ${header})
    list(APPEND headers ${header})
  endforeach()
  target_include_directories(${target} PRIVATE ${folder})
  add_custom_target(${target}_texts DEPENDS ${headers})
  add_dependencies(gurney_texts ${target}_texts)
endfunction()
