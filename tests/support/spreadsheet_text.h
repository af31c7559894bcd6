#pragma once

#include <string>

namespace gurney {

/// A text as spreadsheets save it: lines end with CR LF, a byte order mark stands in front.
inline std::string spreadsheet_text(std::string text) {
  for (auto at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2))
    text.insert(at, 1, '\r');
  return "\xef\xbb\xbf" + text;
}

}  // namespace gurney
