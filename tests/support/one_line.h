#pragma once

#include <string>

#include "studies/render/render.h"

namespace gurney {

/// What people read, without its line breaks and repeated blanks.
inline std::string one_line(const findings::Section& known) {
  std::string all;
  for (const char c : render::text(known))
    if (const char next = c == '\n' ? ' ' : c; next != ' ' || !all.ends_with(' ')) all += next;
  return all;
}

}  // namespace gurney
