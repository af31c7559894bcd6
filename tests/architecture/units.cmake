# Fails where standard gravity or degrees are written as numbers outside engine/base/units.h.
# The default of Scene::gravity is the one exception: a plain number a reader can check.
cmake_minimum_required(VERSION 3.25)
foreach(folder engine groundmotions equipment studies)
  file(GLOB_RECURSE sources RELATIVE ${ROOT} ${ROOT}/${folder}/*.h ${ROOT}/${folder}/*.cpp)
  list(REMOVE_ITEM sources engine/base/units.h)
  foreach(source ${sources})
    file(STRINGS ${ROOT}/${source} bad
      REGEX "9\\.8066|9\\.81[^0-9]|pi *(\\* *1(\\.0)?)? */ *180|180(\\.0*)? */ *(std::numbers::|M_|k)?[pP][iI]|0\\.01745|57\\.29")
    list(FILTER bad EXCLUDE REGEX "double gravity = 9\\.80665;")
    if(bad)
      message(SEND_ERROR "${source}: use engine/base/units.h instead of: ${bad}")
    endif()
  endforeach()
endforeach()
