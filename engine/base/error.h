#pragma once

#include <stdexcept>
#include <string>

namespace gurney {

/// An error of the user: bad input, a file that cannot be read or written.
///
/// The message says what is wrong, the value, and what is allowed; where a file is at fault it
/// starts with `file:line:column: `. Several errors found in one pass are one Error with a line
/// for each. Our own errors are asserts; physics gone wrong is an Outcome in the Response.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message) : std::runtime_error(message) {}
};

/// @throws Error with `message` unless `holds`. State what must hold (`x > 0`), so that NaN fails
/// too.
inline void require(bool holds, const std::string& message) {
  if (!holds) throw Error(message);
}

}  // namespace gurney
