# Writes OUTPUT: the text of SOURCE as the constant embedded::NAME, one in each source that includes it,
# so that rooms may have files of one name.
file(READ "${SOURCE}" text)
if(text MATCHES "\\)embedded\"")
  message(FATAL_ERROR "${SOURCE} has the end of a raw string, )embedded\", in it")
endif()
file(WRITE "${OUTPUT}" "#pragma once\n\n#include <string_view>\n\nnamespace gurney::embedded {\n\n"
  "constexpr std::string_view ${NAME} = R\"embedded(")
file(APPEND "${OUTPUT}" "${text}")
file(APPEND "${OUTPUT}" ")embedded\";\n\n}  // namespace gurney::embedded\n")
