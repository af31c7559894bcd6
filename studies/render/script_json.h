#pragma once

#include <string>

namespace gurney::render {

/// The text of a JSON value within the <script> of a page, which no text of it can end. Names in files may have
/// bytes that are not UTF-8.
template <class Json>
std::string script_json(const Json& value) {
  std::string safe;
  for (const char c : value.dump(-1, ' ', false, Json::error_handler_t::replace))
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  return safe;
}

}  // namespace gurney::render
