#pragma once

#include <string>

#include "engine/base/error.h"

namespace gurney {

/// The message of the Error that `action` throws, or a note that it throws none.
template <typename Action>
std::string error_text(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "(no error)";
}

}  // namespace gurney
