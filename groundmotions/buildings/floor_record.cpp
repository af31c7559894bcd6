#include "groundmotions/buildings/floor_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "groundmotions/measures/peaks.h"

namespace gurney::groundmotions {
namespace {

using std::numbers::pi;

constexpr double kVisibleDrift = 0.01;  ///< after the ground's end; an assumption [m]
constexpr double kShareOfPeak = 0.1;    ///< and of the peak displacement; an assumption
constexpr const char* kBaselineStep = "\"baseline kind=end_at_rest\"";
constexpr double kElasticDrift = 0.01;     ///< storey drift ratio; an assumption
constexpr double kSteadyDrift = 0.04;      ///< of storeys that yield; an assumption
constexpr double kLargestRotation = 0.05;  ///< sin and cos are 1 and 0 within 0.13 % [rad]

/// A finding, and with the words of what follows from it a warning where it is too large.
void report_finding(const std::string& finding, bool too_large, const std::string& therefore,
                    BuildingResponse& response) {
  response.findings.push_back(finding);
  response.floor.processing.push_back(finding);
  if (too_large) response.floor.warnings.push_back(finding + ": " + therefore);
}

/// Peak rotation of the floor; a warning where it is not small.
void report_rotation(Record& floor) {
  const Vector3 peak = floor.rotation->angle.cwiseAbs().rowwise().maxCoeff();
  floor.processing.push_back(
      peak.z() > 0 ? fmt::format("the floor twists: peak {:.3g} rad about the vertical", peak.z())
                   : fmt::format("the floor rotates: peak {:.3g} rad about h1, {:.3g} rad about h2",
                                 peak.x(), peak.y()));
  if (peak.maxCoeff() > kLargestRotation)
    floor.warnings.push_back(
        fmt::format("the floor rotates by {:.3g} rad; the engine takes rotations as small, up to "
                    "{:g} rad, and a building would not stay linear",
                    peak.maxCoeff(), kLargestRotation));
}

/// How much the building's own frequency amplifies the vertical; a warning above 1 g.
void report_vertical(const Record& ground, const Building& building, BuildingResponse& response) {
  const ModalAxis& axis = building[Direction::kVertical];
  if (axis.empty() || !ground[Direction::kVertical]) return;
  const auto peak = [](const Component& component) {
    return peaks(component.time_step, component.acceleration).acceleration;
  };
  const double below = peak(*ground[Direction::kVertical]);
  const double above = peak(*response.floor[Direction::kVertical]);
  if (!(below > 0)) return;
  report_finding(
      fmt::format("vertical amplified {:.2g} times, to {:.3g} g, by the building's own frequency "
                  "({:.3g} Hz, {:.2g} % damping, assumptions of its file)",
                  above / below, above / kStandardGravity, axis.front().omega / (2 * pi),
                  100 * axis.front().damping),
      above > kStandardGravity, "above 1 g what stands on the floor leaves it", response);
}

/// The storey drift ratio, where the building's height is stated; a warning above 1 %.
/// @param largest  difference of the displacements of two floors [m]
void report_storey_drift(double largest, const Building& building, BuildingResponse& response) {
  if (!building.height) return;
  const double ratio = largest / (*building.height / building.storeys);
  response.storey_drift_ratio = ratio;
  if (!response.storeys)
    return report_finding(
        fmt::format("peak storey drift ratio {:.2g} %", 100 * ratio), ratio > kElasticDrift,
        fmt::format("the model is elastic; above {:g} % a building yields, and its floors "
                    "accelerate less",
                    100 * kElasticDrift),
        response);
  const StoreyResponse& storeys = *response.storeys;
  Eigen::Index storey = 0;
  const double ductility = storeys.ductility.maxCoeff(&storey);
  response.residual_drift_ratio =
      storeys.residual_drift.maxCoeff() / (*building.height / building.storeys);
  report_finding(
      fmt::format(
          "peak storey drift ratio {:.2g} %, residual {:.2g} %, ductility {:.2g} in storey {}",
          100 * ratio, 100 * *response.residual_drift_ratio, ductility, storey + 1),
      ratio > kSteadyDrift,
      fmt::format("the storeys of the model keep strength and stiffness; above {:g} % those of a "
                  "building lose them",
                  100 * kSteadyDrift),
      response);
}

/// A ground that moves on when its record ends carries the floor on while the building vibrates:
/// a warning where that is visible.
/// @param tail  time for which it vibrates [s]
void report_drift(const Record& ground, double tail, Record& floor) {
  for (const Direction direction : kDirections) {
    if (!ground[direction] || !floor[direction]) continue;
    const double step = ground.time_step();
    const double speed = std::abs(end_motion(step, ground[direction]->acceleration).velocity);
    const double below = peaks(step, ground[direction]->acceleration).displacement;
    if (speed * tail <= std::max(kVisibleDrift, kShareOfPeak * below)) continue;
    const auto& above = *floor[direction];
    floor.warnings.push_back(fmt::format(
        "{}: the ground still moves at {:.2g} m/s when its record ends; over the {:.3g} s that the "
        "building vibrates on this is {:.2g} m, and the peak displacement of {:.3g} m becomes "
        "{:.3g} m on the floor; correct the baseline of the record first, with the step {}",
        name_of(direction), speed, tail, speed * tail, below,
        peaks(above.time_step, above.acceleration).displacement, kBaselineStep));
  }
}

using std::numbers::pi;

constexpr double kSamplesInPeriod = 20;
constexpr double kShortestPeriod = 1.0 / 33;  ///< [s]
constexpr double kQuiet = 0.01;               ///< of the peak
constexpr double kShortestQuiet = 1;          ///< [s]
constexpr double kLongestTail = 120;          ///< [s]
constexpr double kAccuracy = 1e-3;            ///< of the peaks, at a halving of the step
constexpr int kMaxHalvings = 10;
constexpr double kMaxSteps = 1.5e7;       ///< of one pass; some ten seconds in all
constexpr double kEnergyAccuracy = 1e-6;  ///< of the largest input

std::array<ModalAxis, 2> horizontal(const Building& building) {
  return {building[Direction::kH1], building[Direction::kH2]};
}

/// Shortest and longest period [s]; 0, 0 for a rigid building.
std::pair<double, double> period_range(const Building& building) {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  const auto add = [&](double omega) {
    if (!(omega > 0)) return;
    low = std::min(low, 2 * pi / omega);
    high = std::max(high, 2 * pi / omega);
  };
  for (const ModalAxis& axis : building.axes)
    for (const Mode& mode : axis) add(mode.omega);
  for (const TorsionMode& mode : building.torsion) add(mode.omega);
  if (building.isolation) {
    add(std::sqrt(building.isolation->stiffness));
    if (building.isolation->fast_strength > 0) low = std::min(low, kShortestPeriod);
  }
  return high > 0 ? std::pair(low, high) : std::pair(0.0, 0.0);
}

/// The ground's acceleration, linear between samples, from the last to 0 within one interval.
class Ground {
 public:
  Ground(const Record& record, int refinement) : refinement_(refinement) {
    samples_ = Eigen::Matrix3Xd::Zero(3, record.samples());
    for (const Direction direction : kDirections)
      if (record[direction])
        samples_.row(static_cast<int>(direction)) = record[direction]->acceleration.transpose();
  }

  Eigen::Index steps() const { return (samples_.cols() - 1) * refinement_; }

  Vector3 at(Eigen::Index step) const {
    const Eigen::Index i = step / refinement_;
    if (i >= samples_.cols()) return Vector3::Zero();
    const Vector3 here = samples_.col(i);
    const Vector3 next = i + 1 < samples_.cols() ? Vector3(samples_.col(i + 1)) : Vector3::Zero();
    return here + (next - here) * static_cast<double>(step % refinement_) / refinement_;
  }

 private:
  int refinement_;
  Eigen::Matrix3Xd samples_;
};

/// Says when the floor has come to rest.
class Quiet {
 public:
  explicit Quiet(double window) : window_(window) {}

  void see(double time, const Vector3& acceleration) {
    peak_ = peak_.cwiseMax(acceleration.cwiseAbs());
    if ((acceleration.array().abs() > kQuiet * peak_.array()).any()) loud_ = time;
  }
  bool reached(double time) const { return time - loud_ >= window_; }

 private:
  double window_, loud_ = 0;
  Vector3 peak_ = Vector3::Zero();
};

/// The floor at one time.
struct FloorSample {
  Vector3 acceleration;
  Vector2 dip = Vector2::Zero(), dip_acceleration = Vector2::Zero();  ///< towards h1 and h2
  double drift = 0;                                                   ///< of a storey [m]
  double yaw = 0, yaw_acceleration = 0;
};

struct History {
  std::vector<FloorSample> floor;
  bool quiet = true;
};

using FloorStep = std::function<FloorSample(const Vector3& ground0, const Vector3& ground1)>;

History run(const Ground& ground, double time_step, double window, const FloorSample& first,
            const FloorStep& step) {
  History history;
  history.floor.push_back(first);
  Quiet quiet(window);
  const double end = static_cast<double>(ground.steps()) * time_step;
  for (Eigen::Index i = 0;; ++i) {
    const double time = static_cast<double>(i) * time_step;
    if (i >= ground.steps() && quiet.reached(time)) return history;
    if (time - end >= kLongestTail) break;
    history.floor.push_back(step(ground.at(i), ground.at(i + 1)));
    quiet.see(time + time_step, history.floor.back().acceleration);
  }
  history.quiet = false;
  return history;
}

struct IsolatedHistory {
  History history;
  IsolatorResponse isolators;
  bool lifted = false;
};

IsolatedHistory run_isolated(const Ground& ground, const Building& building, int floor,
                             double time_step, double window, int substeps) {
  IsolatedMotion motion(*building.isolation, horizontal(building), time_step / substeps);
  ModalResponse vertical(building[Direction::kVertical], floor, time_step);
  std::vector<Vector2> displacement = {Vector2::Zero()};
  IsolatedHistory result;
  double largest_input = 0, largest_closure = 0;
  const auto step = [&](const Vector3& ground0, const Vector3& ground1) {
    for (int i = 0; i < substeps; ++i) {
      const Vector3 slope = (ground1 - ground0) / substeps;
      motion.step(ground0 + i * slope, ground0 + (i + 1) * slope);
    }
    displacement.push_back(motion.displacement());
    const IsolationEnergy energy = motion.energy();
    largest_input = std::max(largest_input, std::abs(energy.input));
    largest_closure = std::max(largest_closure, std::abs(energy.closure()));
    const Vector2 level = motion.floor_acceleration(floor);
    const Vector3 moved(level.x(), level.y(), vertical.step(ground0.z(), ground1.z()));
    return FloorSample{moved, motion.floor_dip(floor), motion.floor_dip_acceleration(floor),
                       building.height ? motion.storey_drift() : 0};
  };
  const FloorSample first{Vector3(0, 0, vertical.at_rest(ground.at(0).z()))};
  result.history = run(ground, time_step, window, first, step);

  IsolatorResponse& isolators = result.isolators;
  isolators.displacement.resize(2, static_cast<Eigen::Index>(displacement.size()));
  for (std::size_t i = 0; i < displacement.size(); ++i)
    isolators.displacement.col(static_cast<Eigen::Index>(i)) = displacement[i];
  isolators.peak = isolators.displacement.colwise().norm().maxCoeff();
  isolators.residual = displacement.back();
  isolators.energy = motion.energy();
  isolators.energy_error = largest_input > 0 ? largest_closure / largest_input : 0;
  isolators.time_step = time_step / substeps;
  result.lifted = motion.lifted();
  return result;
}

struct YieldingHistory {
  History history;
  StoreyResponse storeys;
};

YieldingHistory run_yielding(const Ground& ground, const Building& building, int floor,
                             const Vector2& place, double time_step, double window, int substeps) {
  const YieldingStoreys& storeys = *building.yielding;
  YieldingMotion motion(storeys, time_step / substeps);
  ModalResponse vertical(building[Direction::kVertical], floor, time_step);
  YieldingHistory result;
  StoreyResponse& found = result.storeys;
  found.ductility = Eigen::VectorXd::Zero(building.storeys);
  double largest_input = 0, largest_closure = 0;
  const auto step = [&](const Vector3& ground0, const Vector3& ground1) {
    const Vector2 slope = (ground1 - ground0).head<2>() / substeps;
    for (int i = 0; i < substeps; ++i)
      motion.step(ground0.head<2>() + i * slope, ground0.head<2>() + (i + 1) * slope);
    const Eigen::VectorXd drift = motion.column_drift();
    found.ductility = found.ductility.cwiseMax(drift.cwiseQuotient(storeys.yield_drift));
    largest_input = std::max(largest_input, std::abs(motion.energy().input));
    largest_closure = std::max(largest_closure, std::abs(motion.energy().closure()));
    const Vector3 level =
        floor > 0 ? motion.floor_acceleration(floor, place) : Vector3(ground1.x(), ground1.y(), 0);
    return FloorSample{
        .acceleration = {level.x(), level.y(), vertical.step(ground0.z(), ground1.z())},
        .drift = drift.maxCoeff(),
        .yaw = motion.yaw(floor),
        .yaw_acceleration = level.z()};
  };
  const FloorSample first{Vector3(0, 0, vertical.at_rest(ground.at(0).z()))};
  result.history = run(ground, time_step, window, first, step);
  found.residual_drift = motion.column_drift();
  found.energy = motion.energy();
  found.energy_error = largest_input > 0 ? largest_closure / largest_input : 0;
  found.time_step = time_step / substeps;
  return result;
}

/// Largest differences of two horizontal accelerations, of two storey drifts and of two yaw accelerations, each
/// over the peak of the second.
struct Change {
  double acceleration, drift, yaw;
};

Change change_between(const History& coarse, const History& fine) {
  const std::size_t samples = std::min(coarse.floor.size(), fine.floor.size());
  double acceleration = 0, peak_acceleration = 0, drift = 0, peak_drift = 0, yaw = 0, peak_yaw = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    const FloorSample &a = coarse.floor[i], &b = fine.floor[i];
    acceleration = std::max(acceleration, (a.acceleration - b.acceleration).head<2>().norm());
    peak_acceleration = std::max(peak_acceleration, b.acceleration.head<2>().norm());
    drift = std::max(drift, std::abs(a.drift - b.drift));
    peak_drift = std::max(peak_drift, b.drift);
    yaw = std::max(yaw, std::abs(a.yaw_acceleration - b.yaw_acceleration));
    peak_yaw = std::max(peak_yaw, std::abs(b.yaw_acceleration));
  }
  const auto over = [](double difference, double peak) { return peak > 0 ? difference / peak : 0; };
  return {over(acceleration, peak_acceleration), over(drift, peak_drift), over(yaw, peak_yaw)};
}

double change(const IsolatedHistory& coarse, const IsolatedHistory& fine) {
  const Eigen::Index samples =
      std::min(coarse.isolators.displacement.cols(), fine.isolators.displacement.cols());
  const double displacement = (coarse.isolators.displacement.leftCols(samples) -
                               fine.isolators.displacement.leftCols(samples))
                                  .colwise()
                                  .norm()
                                  .maxCoeff();
  const double u = fine.isolators.peak > 0 ? displacement / fine.isolators.peak : 0;
  return std::max(change_between(coarse.history, fine.history).acceleration, u);
}

double change(const YieldingHistory& coarse, const YieldingHistory& fine) {
  const Change found = change_between(coarse.history, fine.history);
  return std::max({found.acceleration, found.drift, found.yaw});
}

/// Halves the step of a solve until that changes the motion by no more than kAccuracy.
/// @param largest  step to begin with [s]
/// @param what     needs so short steps, in an error
/// @param solve    the motion solved with so many steps between two samples
/// @param quality  of a motion: where its `change` stands
template <class Solve, class Quality>
auto halved(const Ground& ground, const Building& building, double time_step, double largest,
            const char* what, const Solve& solve, Quality quality) {
  const double first = std::max(1.0, std::ceil(time_step / largest));
  const auto steps = static_cast<double>(ground.steps());
  require(first * steps <= kMaxSteps,
          fmt::format("building '{}': its {} and shortest period need time steps of {:.2g} s, "
                      "{:.2g} of them for this record; must be at most {:g}",
                      building.name, what, time_step / first, first * steps, kMaxSteps));
  int substeps = static_cast<int>(first);
  auto coarse = solve(substeps);
  for (int halving = 0;; ++halving) {
    substeps *= 2;
    auto fine = solve(substeps);
    (fine.*quality).change = change(coarse, fine);
    const double next = 2.0 * substeps * static_cast<double>(fine.history.floor.size());
    if ((fine.*quality).change <= kAccuracy || halving + 1 == kMaxHalvings || next > kMaxSteps)
      return fine;
    coarse = std::move(fine);
  }
}

IsolatedHistory solve_isolated(const Ground& ground, const Building& building, int floor,
                               double time_step, double window) {
  return halved(
      ground, building, time_step,
      IsolatedMotion::largest_step(*building.isolation, horizontal(building)), "isolators",
      [&](int substeps) {
        return run_isolated(ground, building, floor, time_step, window, substeps);
      },
      &IsolatedHistory::isolators);
}

YieldingHistory solve_yielding(const Ground& ground, const Building& building, int floor,
                               const Vector2& place, double time_step, double window) {
  return halved(
      ground, building, time_step, time_step, "storeys",
      [&](int substeps) {
        return run_yielding(ground, building, floor, place, time_step, window, substeps);
      },
      &YieldingHistory::storeys);
}

History solve_fixed(const Ground& ground, const Building& building, int floor, double time_step,
                    double window) {
  std::vector<ModalResponse> axes;
  FloorSample first;
  for (const Direction direction : kDirections) {
    axes.emplace_back(building[direction], floor, time_step);
    const int row = static_cast<int>(direction);
    first.acceleration[row] = axes.back().at_rest(ground.at(0)[row]);
    if (row < 2) first.dip_acceleration[row] = axes.back().rotation_acceleration(ground.at(0)[row]);
  }
  return run(ground, time_step, window, first, [&](const Vector3& a, const Vector3& b) {
    FloorSample sample{Vector3(axes[0].step(a.x(), b.x()), axes[1].step(a.y(), b.y()),
                               axes[2].step(a.z(), b.z()))};
    for (int row = 0; row < 2; ++row) {
      const ModalResponse& axis = axes[static_cast<std::size_t>(row)];
      sample.dip[row] = axis.rotation();
      sample.dip_acceleration[row] = axis.rotation_acceleration(b[row]);
      if (building.height) sample.drift = std::max(sample.drift, axis.storey_drift());
    }
    return sample;
  });
}

History solve_twisting(const Ground& ground, const Building& building, int floor,
                       const Vector2& place, double time_step, double window) {
  TorsionResponse level(building.torsion, floor, place, time_step);
  ModalResponse vertical(building[Direction::kVertical], floor, time_step);
  const auto sample = [&](const Vector3& below, double up) {
    const Vector3 moved = level.acceleration(below.head<2>());
    FloorSample now{Vector3(moved.x(), moved.y(), up)};
    now.yaw = level.yaw();
    now.yaw_acceleration = moved.z();
    if (building.height) now.drift = level.storey_drift();
    return now;
  };
  const Vector3 start = ground.at(0);
  return run(ground, time_step, window, sample(start, vertical.at_rest(start.z())),
             [&](const Vector3& a, const Vector3& b) {
               level.step(a.head<2>(), b.head<2>());
               return sample(b, vertical.step(a.z(), b.z()));
             });
}

/// A floor that dips towards h1 turns about h2; one that dips towards h2, against h1.
FloorRotation rotation_of(const std::vector<FloorSample>& floor) {
  const auto samples = static_cast<Eigen::Index>(floor.size());
  FloorRotation rotation{Eigen::Matrix3Xd(3, samples), Eigen::Matrix3Xd(3, samples)};
  for (Eigen::Index i = 0; i < samples; ++i) {
    const FloorSample& sample = floor[static_cast<std::size_t>(i)];
    rotation.angle.col(i) << -sample.dip.y(), sample.dip.x(), sample.yaw;
    rotation.acceleration.col(i) << -sample.dip_acceleration.y(), sample.dip_acceleration.x(),
        sample.yaw_acceleration;
  }
  return rotation;
}

double largest_drift(const History& history) {
  double largest = 0;
  for (const FloorSample& sample : history.floor) largest = std::max(largest, sample.drift);
  return largest;
}

/// A floor that twists moves along both horizontals, also where its ground moves along one: the other
/// becomes a component at rest, to be filled like that one.
void complete_horizontals(Record& record) {
  const bool h1 = record[Direction::kH1].has_value(), h2 = record[Direction::kH2].has_value();
  if (h1 == h2) return;
  const Direction missing = h1 ? Direction::kH2 : Direction::kH1;
  const Component& given = *record[h1 ? Direction::kH1 : Direction::kH2];
  Component& rest = record.components[static_cast<std::size_t>(missing)].emplace();
  rest.name = name_of(missing);
  rest.direction = missing;
  rest.time_step = given.time_step;
  rest.acceleration = Eigen::VectorXd::Zero(given.acceleration.size());
  record.processing.push_back(
      fmt::format("{}: not in the record; the ground rests along it", name_of(missing)));
}

std::string period_text(const ModalAxis& axis) {
  return axis.empty() ? "rigid" : fmt::format("{:.4g} s", 2 * pi / axis.front().omega);
}

std::string description(const Building& building, int floor) {
  return fmt::format(
      "floor {} of building '{}' ({} storeys, {}; first periods of the building above: h1 {}, h2 "
      "{}, vertical {})",
      floor, building.name, building.storeys,
      building.isolation          ? building.isolation->name + " isolation"
      : building.yielding         ? building.torsion.empty() ? "fixed base, storeys yield"
                                                             : "fixed base, storeys yield and twist"
      : !building.torsion.empty() ? "fixed base, floors twist"
                                  : "fixed base",
      period_text(building[Direction::kH1]), period_text(building[Direction::kH2]),
      period_text(building[Direction::kVertical]));
}

/// Warnings where a motion of so many solves is not accurate.
/// @param what  moved, in a warning
void report_accuracy(const char* what, double energy_error, double change, double time_step,
                     Record& floor) {
  if (!(energy_error <= kEnergyAccuracy))
    floor.warnings.push_back(fmt::format("{}: the energies miss {:.2g} of the input; wanted: {:g}",
                                         what, energy_error, kEnergyAccuracy));
  if (!(change <= kAccuracy))
    floor.warnings.push_back(
        fmt::format("{}: the motion still changes by {:.2g} of its peak between steps of "
                    "{:.3g} s and twice that; wanted: {:g}",
                    what, change, time_step, kAccuracy));
}

void report_storeys(const StoreyResponse& storeys, Record& floor) {
  floor.processing.push_back(
      fmt::format("storeys yield: ductility {:.3g}, residual drift {:.3g} m, solved with steps of "
                  "{:.3g} s; the "
                  "last halving changed the motion by {:.2g} of its peak; energy closes to {:.1g}",
                  storeys.ductility.maxCoeff(), storeys.residual_drift.maxCoeff(),
                  storeys.time_step, storeys.change, storeys.energy_error));
  report_accuracy("storeys", storeys.energy_error, storeys.change, storeys.time_step, floor);
}

void report_isolators(const IsolatedHistory& history, const Isolation& isolation, Record& floor) {
  const IsolatorResponse& isolators = history.isolators;
  floor.processing.push_back(fmt::format(
      "isolators: peak displacement {:.4g} m, residual {:.3g} m, solved with steps of {:.3g} s; "
      "the last halving changed the motion by {:.2g} of its peak; energy closes to {:.1g}",
      isolators.peak, isolators.residual.norm(), isolators.time_step, isolators.change,
      isolators.energy_error));
  if (isolators.peak > isolation.capacity)
    floor.warnings.push_back(fmt::format(
        "isolators: peak displacement {:.4g} m exceeds the capacity of {:.4g} m; the building "
        "would strike the moat wall, which is not modelled",
        isolators.peak, isolation.capacity));
  if (history.lifted)
    floor.warnings.push_back(
        "isolators: the vertical motion takes all load off (below -1 g); uplift is not modelled");
  report_accuracy("isolators", isolators.energy_error, isolators.change, isolators.time_step,
                  floor);
}

}  // namespace

bool rocks(const Building& building, int floor) {
  for (const ModalAxis& axis : horizontal(building))
    for (const Mode& mode : axis)
      if (rotation_of(mode, floor) != 0) return true;
  return false;
}

BuildingResponse building_response(const Record& ground, const Building& building, int floor,
                                   const Vector2& place) {
  require(ground.samples() > 1, fmt::format("record '{}' has no component", ground.name));
  require(floor >= 0 && floor <= building.storeys,
          fmt::format("building '{}' has no floor {}; floors are 0 (the base) to {} (the roof)",
                      building.name, floor, building.storeys));
  BuildingResponse response;
  Record& record = response.floor;
  record = building.tables
               ? floor_from_tables(ground, *building.tables, static_cast<std::size_t>(floor))
               : ground;
  record.name =
      fmt::format("{}, floor {} of {}", ground.name, name_of_floor(building, floor), building.name);
  if (building.tables) return response;
  record.processing.push_back(description(building, floor));
  if (floor == 0 && !building.isolation) return response;
  if (!building.torsion.empty()) complete_horizontals(record);

  const auto [shortest, longest] = period_range(building);
  const double wanted = std::max(shortest, kShortestPeriod) / kSamplesInPeriod;
  const int refinement =
      shortest > 0 ? static_cast<int>(std::ceil(ground.time_step() / wanted * (1 - 1e-9))) : 1;
  const double time_step = ground.time_step() / std::max(refinement, 1);
  const double window = std::max(longest, kShortestQuiet);
  const Ground motion(ground, std::max(refinement, 1));

  History history;
  if (building.isolation) {
    IsolatedHistory isolated = solve_isolated(motion, building, floor, time_step, window);
    report_isolators(isolated, *building.isolation, record);
    response.isolators = std::move(isolated.isolators);
    history = std::move(isolated.history);
  } else if (building.yielding) {
    YieldingHistory yielding = solve_yielding(motion, building, floor, place, time_step, window);
    report_storeys(yielding.storeys, record);
    response.storeys = std::move(yielding.storeys);
    history = std::move(yielding.history);
  } else if (!building.torsion.empty()) {
    history = solve_twisting(motion, building, floor, place, time_step, window);
  } else {
    history = solve_fixed(motion, building, floor, time_step, window);
  }

  const auto samples = static_cast<Eigen::Index>(history.floor.size());
  record.processing.push_back(
      fmt::format("{:.4g} s of vibration after the ground's last sample; samples every {:.6g} s",
                  static_cast<double>(samples - 1 - motion.steps()) * time_step, time_step));
  if (!history.quiet)
    record.warnings.push_back(fmt::format(
        "the floor still moves {:g} s after the ground stopped; cut there", kLongestTail));
  for (const Direction direction : kDirections) {
    auto& component = record.components[static_cast<std::size_t>(direction)];
    if (!component) continue;
    component->time_step = time_step;
    component->acceleration.resize(samples);
    for (Eigen::Index i = 0; i < samples; ++i)
      component->acceleration[i] =
          history.floor[static_cast<std::size_t>(i)].acceleration[static_cast<int>(direction)];
  }
  if (rocks(building, floor) || !building.torsion.empty()) {
    record.rotation = rotation_of(history.floor);
    report_rotation(record);
  }
  report_vertical(ground, building, response);
  report_storey_drift(largest_drift(history), building, response);
  report_drift(ground, static_cast<double>(samples - 1 - motion.steps()) * time_step, record);
  return response;
}

Record floor_record(const Record& ground, const Building& building, int floor,
                    const Vector2& place) {
  return building_response(ground, building, floor, place).floor;
}

}  // namespace gurney::groundmotions
