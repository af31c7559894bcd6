# Writes OUTPUT: the text of SOURCE as the constant embedded::NAME.
file(READ "${SOURCE}" text)
if(text MATCHES "\\)embedded\"")
  message(FATAL_ERROR "${SOURCE} has the end of a raw string, )embedded\", in it")
endif()
file(WRITE "${OUTPUT}" "#pragma once\n\n#include <string_view>\n\nnamespace gurney::embedded {\n\n"
  "inline constexpr std::string_view ${NAME} = R\"embedded(")
file(APPEND "${OUTPUT}" "${text}")
file(APPEND "${OUTPUT}" ")embedded\";\n\n}  // namespace gurney::embedded\n")
