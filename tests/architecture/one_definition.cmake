# Fails when two types of one name are defined in one namespace, in headers or outside of anonymous
# namespaces in sources. The linker would keep one's functions for both, without a word.
cmake_minimum_required(VERSION 3.25)
file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/engine/*.h ${ROOT}/engine/*.cpp
  ${ROOT}/groundmotions/*.h ${ROOT}/groundmotions/*.cpp ${ROOT}/equipment/*.h
  ${ROOT}/equipment/*.cpp ${ROOT}/studies/*.h ${ROOT}/studies/*.cpp)
foreach(file ${files})
  file(STRINGS ${ROOT}/${file} lines
    REGEX "^(}  // namespace|namespace [a-z_:]*[ ]?{|(struct|class|union|enum|enum class) [A-Za-z]+[^;]*{)")
  set(open "")  # the namespaces around a line, innermost last
  foreach(line IN LISTS lines)
    if(line MATCHES "^}")
      list(POP_BACK open)
    elseif(line MATCHES "^namespace ([a-z_:]*)")
      list(APPEND open "/${CMAKE_MATCH_1}")
    elseif(NOT "/" IN_LIST open AND line MATCHES "^(struct|class|union|enum class|enum) ([A-Za-z]+)( final)?( :[^:]| {)")
      string(REPLACE ";" "" at "${open}")
      set(name "type${at}/${CMAKE_MATCH_2}")
      if(DEFINED "${name}")
        message(SEND_ERROR "${CMAKE_MATCH_2} is defined in ${${name}} and in ${file}")
      endif()
      set("${name}" ${file})
    endif()
  endforeach()
endforeach()
