#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "studies/results/study_reader.h"

namespace gurney::study {

/// One run of a study that was never simulated; item `cart`.
struct SyntheticRun {
  std::size_t configuration = 0, record = 0;
  double level = 1;         ///< the study's intensity [m/s2], and the factor on the record
  double displacement = 0;  ///< peak [m]
  double angle = 0;         ///< [rad]
  int draw = -1;
  bool fell = false, failed = false;
  double pfv = 0.1;  ///< [m/s]
  int replica = 0;
  double half_step = -1;  ///< peak displacement at half the step [m]; < 0: not repeated
  /// Peak acceleration of its marked point `top`, and that at half the step [m/s2]; none in any run:
  /// the file has no such tables.
  std::optional<double> acceleration = {}, half_step_acceleration = {};
  std::map<std::string, double> drawn = {};  ///< by variable, of this draw
  std::optional<double> magnitude = {};      ///< none in any run: the file has no such column
};

/// A study file with known outcomes.
struct SyntheticRuns {
  std::string job;  ///< its configurations' factor, if any, is named "brakes"
  std::vector<std::string> configurations{""}, records;
  std::vector<std::string> files;  ///< of the records; empty: their names
  std::vector<SyntheticRun> runs;
  std::vector<std::string> design = {};  ///< inputs of a Saltelli design
  std::string measure = "PGA h1";
  std::string commit = "abc";
  int format_version = kStudyFormatVersion;
  std::string caster_sha256 = "c1";
  std::vector<std::string> scales = {};  ///< of the records; empty: the file has no such column

  void write(const std::string& path) const;
};

/// These runs of one configuration under `records` records r0, r1 and so on.
SyntheticRuns study_of_records(std::size_t records, const std::vector<SyntheticRun>& runs);

/// Levels 1 and 2 m/s2 of PGA, limit states `moved` (above 0.1 m) and `fell`, and what is given.
std::string synthetic_job(const std::string& in_study = "", const std::string& after = "");

/// A factor with the configurations false and true.
inline constexpr const char* kBrakes =
    "[[study.factor]]\nname = \"brakes\"\nkey = \"item.brakes\"\nvalues = [false, true]\n";

}  // namespace gurney::study
