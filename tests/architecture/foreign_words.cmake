# Fails where the project names a folder of one machine or has loose ends, and where pages, texts of
# the program or names in it use words that no other program of the field uses (docs/glossary.md has
# the field's).
# The patterns are written with brackets so that this file does not match itself.
cmake_minimum_required(VERSION 3.25)
set(foreign "[/]home/[a-z]|[/]root/|[/]tmp/[a-z]|(TOD[O]|FIXM[E]|HAC[K])[ :(]")
foreach(folder engine groundmotions equipment studies tests docs)
  file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/${folder}/*.h ${ROOT}/${folder}/*.cpp
    ${ROOT}/${folder}/*.md ${ROOT}/${folder}/*.toml ${ROOT}/${folder}/*.cmake
    ${ROOT}/${folder}/*.txt ${ROOT}/${folder}/*.py)
  list(APPEND all_files ${files})
endforeach()
foreach(file ${all_files} README.md CHANGELOG.md CMakeLists.txt dev .ci/run)
  if(EXISTS ${ROOT}/${file})
    file(STRINGS ${ROOT}/${file} bad REGEX "${foreign}")
    if(bad)
      message(SEND_ERROR "${file} holds words that do not belong here: ${bad}")
    endif()
  endif()
endforeach()

# The field reports errors, runs an IDA (its key is `ida`), balances energy, compares and excludes.
set(private "([Tt]old|[Tt]ells|[Mm]istakes?|[Ff]ells|is no [a-z]+ file|([Aa]|[Tt]he) hunt|hunts|(held|hold it) against|left out|went in|made again)")
set(of_pages "(${private}|energy account)")

# read_lines(file outcome): its lines, without the signs that a list of CMake cannot hold.
function(read_lines file outcome)
  file(READ ${ROOT}/${file} text)
  string(REPLACE "\\\"" "'" text "${text}")
  string(REGEX REPLACE "[][;\\]" "/" text "${text}")
  string(REPLACE "\n" ";" lines "${text}")
  set(${outcome} "${lines}" PARENT_SCOPE)
endfunction()

# Pages, without what stands in backquotes and without rows of tables that the program writes.
file(GLOB_RECURSE pages RELATIVE ${ROOT} ${ROOT}/docs/*.md)
foreach(page IN LISTS pages ITEMS README.md)
  if(EXISTS ${ROOT}/${page})
    read_lines(${page} lines)
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "`[^`]*`" "" prose "${line}")
      if(NOT line MATCHES "^[|] `" AND prose MATCHES "(^|[^A-Za-z_-])${of_pages}($|[^A-Za-z_-])")
        message(SEND_ERROR "${page} says '${CMAKE_MATCH_2}': ${line}")
      endif()
    endforeach()
  endif()
endforeach()

# Texts of the program, without the cases of `gurney verify`, whose texts are in the tables of
# docs/verification_tables.md.
set(sources ${all_files})
list(FILTER sources INCLUDE REGEX "^(engine|groundmotions|equipment|studies)/.*[.](h|cpp)$")
list(FILTER sources EXCLUDE REGEX "^studies/verification/cases/")
foreach(source IN LISTS sources)
  file(STRINGS ${ROOT}/${source} candidates REGEX "\".*${private}")
  if(candidates)
    read_lines(${source} lines)
    list(FILTER lines INCLUDE REGEX "\".*${private}")
    list(FILTER lines EXCLUDE REGEX "^ *(//|#include)")
    foreach(line IN LISTS lines)
      string(REGEX MATCHALL "\"[^\"]*\"" texts "${line}")
      list(FILTER texts INCLUDE REGEX "[^A-Za-z_-]${private}[^A-Za-z_-]")
      if(texts)
        message(SEND_ERROR "${source} prints a private word: ${texts}")
      endif()
    endforeach()
  endif()
endforeach()

# Names in the code.
set(identifiers "([Mm]istakes?|[Tt]old|[Tt]ells)")
foreach(source IN LISTS sources)
  file(STRINGS ${ROOT}/${source} lines REGEX "(^|[^A-Za-z_])${identifiers}($|[^A-Za-z_])")
  if(lines)
    message(SEND_ERROR "${source} names what the field calls otherwise: ${lines}")
  endif()
endforeach()
