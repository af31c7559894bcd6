#pragma once

#include <fstream>
#include <string>

namespace gurney::groundmotions {

/// The indented lines of docs/formats/record_files.md that follow the line `title`, up to the next line
/// of text.
inline std::string page_example(const std::string& title) {
  std::ifstream stream(GURNEY_SOURCE_DIR "/docs/formats/record_files.md");
  std::string text, line;
  while (std::getline(stream, line) && line != title) {
  }
  while (std::getline(stream, line)) {
    if (line.starts_with("    "))
      text += line.substr(4) + "\n";
    else if (!text.empty())
      break;
  }
  return text;
}

}  // namespace gurney::groundmotions
