# Fails where a range-for runs over what an element of a temporary holds, as in
# `for (x : run().items[0].history)`: before C++23 the temporary is gone when the loop begins. Give
# the temporary a name.
cmake_minimum_required(VERSION 3.25)
set(arguments "\\(([^();]|\\([^();]*\\))*\\)")
set(loop "for \\([^\n:{};()]*[]a-z0-9_] ?:[ \n]+[A-Za-z_0-9:.<>-]+${arguments}[A-Za-z_0-9.]*(\\[|[.](at|front|back|value)\\()")
foreach(folder engine groundmotions equipment studies tests)
  file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/${folder}/*.h ${ROOT}/${folder}/*.cpp)
  foreach(file ${files})
    file(READ ${ROOT}/${file} text)
    if(text MATCHES "${loop}")
      message(SEND_ERROR "${file}: a loop over a part of a temporary: ${CMAKE_MATCH_0}")
    endif()
  endforeach()
endforeach()
