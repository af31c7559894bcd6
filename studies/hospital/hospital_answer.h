#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/hospital/hospital.h"
#include "studies/hospital/outcomes.h"
#include "studies/statistics/bands.h"

namespace gurney::study {

struct HospitalRequest {
  std::size_t samples = 10000;  ///< of motion and pieces
  std::uint64_t seed = 1;
  int threads = 1;
  std::string results{};       ///< of the hospital's study; empty: curves
  std::optional<double> at{};  ///< level at which actions are ranked; none: the middle one
  std::string by{};            ///< "beds", "loss" or a service; empty: beds, or loss without any
};

/// A number with the interval of what the records leave open, and of the samples.
struct Answer {
  double value = 0;
  statistics::Interval interval;
};

struct ServiceAnswer {
  std::string name;
  Answer works;  ///< probability
  /// With pieces independent and wholly dependent given the motion, of curves alone.
  std::optional<double> independent, dependent;
};

/// What one motion does.
struct LevelAnswer {
  double pgv = 0;
  std::vector<ServiceAnswer> services, rooms;  ///< rooms: mean over the copies
  Answer beds_out, loss;
  double beds_out_p95 = 0, loss_p95 = 0;  ///< that 95 % of the samples do not exceed
};

/// Once a year on average, with a hazard.
struct AnnualAnswer {
  std::vector<std::pair<std::string, Answer>> lost;  ///< times a year that a service is lost
  Answer beds_out, loss;
};

/// One action on one group of pieces.
struct RankedAction {
  std::string name, group;  ///< group: "bay/pole"
  int pieces = 0;
  double cost = 0;
  Answer gain;                ///< of what is ranked by, on top of those before it
  double beds = 0, loss = 0;  ///< gain of both
  double left = 0;            ///< of what is ranked by, after it
  bool taken = false;         ///< false: it gains nothing after those that are taken
};

struct HospitalAnswer {
  std::size_t pieces = 0, samples = 0, records = 0;
  int beds = 0;
  std::string money;
  std::vector<LevelAnswer> levels;
  std::optional<AnnualAnswer> annual;
  double ranked_at = 0;   ///< PGV
  std::string ranked_by;  ///< "beds out of use", "loss" or "chance that ... is lost"
  double before = 0;      ///< any action
  std::vector<RankedAction> ranking;
  std::vector<std::string> cautions;
};

/// Samples motions and pieces. Numbers depend on hospital, files, samples and seed alone.
/// @throws Error with places
HospitalAnswer hospital_answer(const Hospital& hospital, const Consequences& consequences,
                               const HospitalRequest& request);

}  // namespace gurney::study
