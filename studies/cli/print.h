#pragma once

#include <fmt/format.h>

#include "studies/render/render.h"

namespace gurney::cli {

/// Prints what is known, for people or for programs.
/// @param known  a section, or several
inline void print_findings(const auto& known, bool json) {
  fmt::print("{}", json ? render::json(known) : render::text(known));
}

}  // namespace gurney::cli
