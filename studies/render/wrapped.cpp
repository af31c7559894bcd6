#include "studies/render/wrapped.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string_view>

namespace gurney::render {
namespace {

Colour stated = Colour::kAuto;

std::string_view variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

bool is_emphasised() {
  if (stated != Colour::kAuto) return stated == Colour::kAlways;
  return isatty(STDOUT_FILENO) == 1 && variable("TERM") != "dumb" && variable("NO_COLOR").empty();
}

}  // namespace

namespace {

constexpr std::size_t kFewest = 40;

/// 0: not known.
std::size_t stated_columns() {
  winsize window{};
  if (const char* text = std::getenv("COLUMNS")) return std::strtoul(text, nullptr, 10);
  return ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0 ? window.ws_col : 0;
}

}  // namespace

std::size_t columns() {
  constexpr std::size_t kMost = 100;
  const std::size_t found = stated_columns();
  return found == 0 ? kMost : std::clamp(found, kFewest, kMost);
}

std::size_t table_columns() {
  const std::size_t found = stated_columns();
  return found == 0 ? std::string::npos : std::max(found, kFewest);
}

std::string wrapped(const std::string& text, std::size_t indent, std::size_t used) {
  const std::size_t most = columns();
  std::istringstream words(text);
  std::string result, word;
  std::size_t column = used;
  bool first = true;
  while (words >> word) {
    if (!first && column + 1 + word.size() > most) {
      result.append("\n").append(indent, ' ');
      column = indent;
    } else if (!first) {
      result += " ";
      ++column;
    }
    result += word;
    column += word.size();
    first = false;
  }
  return result;
}

void set_colour(Colour when) { stated = when; }

std::string bold(const std::string& text) {
  return text.empty() || !is_emphasised() ? text : "\x1b[1m" + text + "\x1b[0m";
}

}  // namespace gurney::render
