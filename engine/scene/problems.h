#pragma once

#include <string>

#include "engine/base/diagnostics.h"
#include "engine/base/vector.h"

namespace gurney {

/// Checks numbers of a scene against their ranges; an error reads `name = value: must be ...`.
class Problems {
 public:
  void set_prefix(const std::string& prefix) { prefix_ = prefix; }  ///< of what comes after

  void add(const std::string& line) { errors_.add(prefix_ + line); }
  void check(bool holds, const std::string& line);
  void check(bool holds, const std::string& name, double value, const std::string& allowed);
  void positive(const std::string& name, double value);      ///< and finite
  void not_negative(const std::string& name, double value);  ///< and finite
  void finite(const std::string& name, const Vector3& value);
  void direction(const std::string& name, const Vector3& value);  ///< finite, of some length

  /// A rigid body has a symmetric inertia whose largest principal moment is at most the sum of the
  /// other two.
  /// @param positive  each moment must be > 0, else >= 0
  void inertia(const std::string& name, const Matrix3& value, bool positive);

  void finish() const { errors_.raise(); }  ///< @throws Error with all, if there are any

 private:
  std::string prefix_;
  Diagnostics errors_;
};

}  // namespace gurney
