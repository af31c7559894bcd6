#pragma once

#include <string>
#include <vector>

namespace gurney::study {

/// A unit that reports and figures print values in.
struct ReportUnit {
  std::string name;
  double in_si = 1;
};

/// The units in which results are printed and drawn, whatever they are computed in: SI.
class UnitSystem {
 public:
  UnitSystem() = default;  ///< those of the job: g and degrees, else SI

  /// @param name  of names()
  /// @throws Error with the nearest name
  explicit UnitSystem(const std::string& name);

  static std::vector<std::string> names();

  /// Whether it is stated, and so rules over the units of the job.
  bool chosen() const { return row_ != nullptr; }

  /// Itself, or the system of this name where none is stated: what does not follow the job.
  UnitSystem or_else(const char* name) const;

  /// @param si  the unit in SI: "m", "m/s2", "N s", "1"
  ReportUnit of(const std::string& si) const;

  /// "12.30": as many decimals as say at least as much as `decimals` of the job's unit.
  std::string number(double value, const std::string& si, int decimals) const;

  /// "12.30 cm": number() and the unit.
  std::string fixed(double value, const std::string& si, int decimals) const;

  /// "12.3 cm": three digits, or all before the point, and the unit.
  std::string text(double value, const std::string& si) const;

 private:
  struct Row;
  static const Row kRows[];
  const Row* row_ = nullptr;
};

}  // namespace gurney::study
