#include "studies/render/emphasis.h"

#include <unistd.h>

#include <cstdlib>
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

void set_colour(Colour when) { stated = when; }

std::string bold(const std::string& text) {
  return text.empty() || !is_emphasised() ? text : "\x1b[1m" + text + "\x1b[0m";
}

}  // namespace gurney::render
