#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace gurney::groundmotions {

/// The indented lines that follow the line `title`, up to the next line of text.
inline std::string page_example(const std::string& page, const std::string& title) {
  std::ifstream stream(std::filesystem::path(GURNEY_SOURCE_DIR) / "docs/formats" / page);
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
