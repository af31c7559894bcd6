# Fails where the project names a folder of one machine or loose ends that must not be released.
# The patterns are written with brackets so that this file does not match itself.
cmake_minimum_required(VERSION 3.25)
set(foreign "[/]work/|[/]home/[a-z]|[/]root/|[/]tmp/[a-z]|[.][.]/share[d]/(design|research|source)|(TOD[O]|FIXM[E]|HAC[K])[ :(]|before-sto[p]|subagen[t]|helper sessio[n]|this sessio[n]")
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
