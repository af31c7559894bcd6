#pragma once

#include <string>

#include "engine/base/error.h"

namespace gurney {

/// What the Error thrown by `action` says; empty if there is none.
template <typename Action>
std::string error_text(Action&& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace gurney
