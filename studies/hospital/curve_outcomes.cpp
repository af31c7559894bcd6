#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>

#include "engine/base/append_all.h"
#include "engine/base/csv_row.h"
#include "engine/base/error.h"
#include "engine/base/names.h"
#include "engine/base/number_text.h"
#include "engine/base/random/normal_draw.h"
#include "engine/config/nearest_name.h"
#include "equipment/catalogue/data_folder.h"
#include "groundmotions/formats/source_file.h"
#include "studies/hospital/outcomes.h"
#include "studies/statistics/special.h"

namespace gurney::study {
namespace {

constexpr const char *kFloorVelocity = "pfv", *kGroundVelocity = "PGV larger";
constexpr double kNormal95 = 1.959963984540054;
constexpr double kSameVelocity = 1e-9;  ///< rounding of a file, over the velocity
constexpr double kFarScatter = 1.645;   ///< deviations that one sample in twenty exceeds
constexpr std::size_t kSupported =
    10;  ///< runs that exceed; the parameters of a curve of fewer are loose

/// A capacity of ln theta + beta z, and the standard error of ln theta.
struct Capacity {
  double log_theta, beta, error;
};

/// How many of the motions exceed at a velocity or just above it.
struct Count {
  double velocity;
  std::size_t exceed, motions;
};

/// Equipment, floor, place, brakes, measure.
using Setting = std::tuple<std::string, std::string, std::string, std::string, std::string>;

struct State {
  std::string name;
  std::optional<Capacity> capacity;         ///< none: no curve
  std::optional<std::size_t> exceed, runs;  ///< where the table has these columns
  std::vector<Count> counts;                ///< by rising velocity

  bool few() const { return !capacity || (exceed && *exceed < kSupported); }
};

using States = std::map<Setting, std::vector<State>>;

State& state_in(States& states, const Setting& setting, const std::string& name) {
  std::vector<State>& of = states[setting];
  const auto found = std::ranges::find(of, name, &State::name);
  return found != of.end() ? *found : of.emplace_back(State{name, {}, {}, {}, {}});
}

/// A table in the columns of docs/catalogue/data/fragility.csv, or of above.csv, which has one of counts
/// `k/n` for each velocity.
class CurveFile {
 public:
  CurveFile(const std::string& path, States& into) : path_(path), into_(into) {
    const groundmotions::SourceFile file(path);
    line_ = file.blank_lines();
    for (const std::string_view line : file.lines()) {
      ++line_;
      if (trimmed(line).empty()) continue;
      cells_ = csv_row(line);
      if (columns_.empty())
        take_titles();
      else if (velocities_.empty())
        take_curve();
      else
        take_counts();
    }
  }

 private:
  [[noreturn]] void fail(std::size_t column, const std::string& message) const {
    throw Error(fmt::format("{}:{}:{}: {}", path_, line_, column, message));
  }

  void take_titles() {
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      columns_[cells_[i].text] = i;
      const std::optional<double> velocity = number(cells_[i].text);
      if (velocity && *velocity > 0) velocities_.emplace_back(*velocity, cells_[i].text);
    }
    std::ranges::sort(velocities_);
    std::vector<const char*> needed = {"item",   "floor",       "place",
                                       "brakes", "limit_state", "measure"};
    if (velocities_.empty())
      needed.insert(needed.end(), {"theta", "theta_low", "theta_high", "beta", "reason"});
    for (const char* name : needed)
      if (!columns_.contains(name)) fail(1, fmt::format("no column '{}'", name));
  }

  const CsvCell& cell(const std::string& column) const {
    const std::size_t i = columns_.at(column);
    if (i >= cells_.size()) fail(1, fmt::format("no value in the column '{}'", column));
    return cells_[i];
  }
  const std::string& text(const std::string& column) const { return cell(column).text; }

  std::optional<double> value(const char* column) const {
    const std::string& stated = text(column);
    if (stated.empty() || stated == "inf") return {};
    const std::optional<double> found = number(stated);
    if (!found || *found < 0)
      fail(cell(column).column, fmt::format("{} = '{}': must be a number >= 0", column, stated));
    return found;
  }

  std::optional<std::size_t> whole(const char* column) const {
    if (!columns_.contains(column)) return {};
    const std::optional<double> found = value(column);
    if (found && *found != std::floor(*found))
      fail(cell(column).column,
           fmt::format("{} = '{}': must be a whole number >= 0", column, text(column)));
    return found ? std::optional(static_cast<std::size_t>(*found)) : std::nullopt;
  }

  /// Half the 95 % interval of ln theta over 1.96; from one end where the other is not bounded.
  double error_of(double theta) const {
    const std::optional<double> low = value("theta_low"), high = value("theta_high");
    double width = 0, sides = 0;
    for (const std::optional<double>& end : {low, high})
      if (end && *end > 0) {
        width += std::abs(std::log(*end / theta));
        ++sides;
      }
    return sides > 0 ? width / sides / kNormal95 : 0;
  }

  State& state() const {
    return state_in(into_,
                    {text("item"), text("floor"), text("place"), text("brakes"), text("measure")},
                    text("limit_state"));
  }

  void take_curve() {
    const std::optional<double> theta = value("theta"), beta = value("beta");
    State& of = state();
    of.exceed = whole("exceed");
    of.runs = whole("runs");
    if (!of.exceed && text("reason").starts_with("no run exceeds")) of.exceed = 0;
    if (theta && beta && *theta > 0 && *beta > 0)
      of.capacity = Capacity{std::log(*theta), *beta, error_of(*theta)};
  }

  void take_counts() {
    State& of = state();
    for (const auto& [velocity, title] : velocities_) {
      const std::string& stated = text(title);
      const std::size_t slash = stated.find('/');
      const std::string total = slash == std::string::npos ? "" : stated.substr(slash + 1);
      const std::optional<double> exceed = number(stated.substr(0, slash)), motions = number(total);
      if (!exceed || !motions || !(0 <= *exceed && *exceed <= *motions) ||
          *exceed != std::floor(*exceed) || *motions != std::floor(*motions))
        fail(cell(title).column,
             fmt::format("{} = '{}': must be k/n, k of n motions that exceed", title, stated));
      if (*motions > 0)
        of.counts.push_back(
            {velocity, static_cast<std::size_t>(*exceed), static_cast<std::size_t>(*motions)});
    }
  }

  std::string path_;
  States& into_;
  std::map<std::string, std::size_t> columns_;
  std::vector<std::pair<double, std::string>> velocities_;  ///< with their titles
  std::vector<CsvCell> cells_;
  std::size_t line_ = 0;
};

/// The score below which a piece reaches a state of which k of n outcomes are known, as a function of the
/// replicate's score s: that of the chance p, the quantile of Beta(k + 1/2, n - k + 1/2) (Jeffreys) at Phi(-s).
/// Linear between scores 0.1 apart.
class Threshold {
 public:
  Threshold(std::size_t exceed, std::size_t outcomes) {
    const double k = static_cast<double>(exceed), n = static_cast<double>(outcomes);
    for (std::size_t i = 0; i < kPoints; ++i) {
      const double p = statistics::beta_quantile(normal_cdf(-score(static_cast<double>(i))),
                                                 k + 0.5, n - k + 0.5);
      of_[i] = normal_quantile(std::clamp(p, 1e-12, 1 - 1e-12));
    }
  }

  double operator()(double shift) const {
    const double at = std::clamp((shift + kEnd) / kStep, 0.0, static_cast<double>(kPoints - 1));
    const auto i = std::min(kPoints - 2, static_cast<std::size_t>(at));
    return std::lerp(of_[i], of_[i + 1], at - static_cast<double>(i));
  }

 private:
  static constexpr double kEnd = 4, kStep = 0.1;
  static constexpr std::size_t kPoints = 81;
  static double score(double i) { return -kEnd + kStep * i; }

  std::array<double, kPoints> of_{};
};

/// A state of one piece: reached where the intensity exceeds its capacity, and the score its thresholds.
struct Reach {
  Reached state = 0;
  std::optional<Capacity> capacity;
  std::vector<std::pair<double, Threshold>> thresholds;  ///< up to ln of a velocity, by rising ones

  bool operator()(double log_im, double score, double shift) const {
    if (!capacity && thresholds.empty()) return false;
    if (capacity &&
        !(log_im > capacity->log_theta + capacity->error * shift + capacity->beta * score))
      return false;
    if (thresholds.empty()) return true;
    const auto above = std::ranges::find_if(
        thresholds, [&](const auto& each) { return log_im <= each.first + kSameVelocity; });
    return score < (above == thresholds.end() ? thresholds.back() : *above).second(shift);
  }
};

class CurveOutcomes : public OutcomeSource {
 public:
  CurveOutcomes(const Hospital& hospital, const Consequences& consequences, double correlation)
      : hospital_(hospital), correlation_(correlation), consequences_(consequences) {
    std::vector<std::string> files = hospital.curves;
    const std::string data = equipment::find_data_folder().path + "/docs/catalogue/data/";
    if (files.empty())
      files = {data + "fragility.csv", data + "more_states.csv", data + "above.csv"};
    for (const std::string& file : files) CurveFile(file, settings_);
    std::vector<std::string> of_curves;
    for (const auto& [setting, states] : settings_) append_all(of_curves, names_of(states));
    states_ = state_names(consequences, of_curves, hospital.path);
  }

  const std::vector<std::string>& states() const override { return states_; }

  Outcome outcome(const HospitalItem& item, const Storey& storey, Brakes brakes) const override {
    const char* const measure = storey.amplification ? kFloorVelocity : kGroundVelocity;
    const auto found = settings_.find({item.equipment, storey.floor, item.place,
                                       brakes_names()[static_cast<std::size_t>(brakes)], measure});
    if (found == settings_.end()) refuse(item, storey, brakes, measure);
    note_missing(item, found->second);
    std::vector<double> log_im;
    for (const double level : hospital_.levels)
      log_im.push_back(std::log(level * storey.amplification.value_or(1)));
    std::vector<Reach> reaches;
    for (const State& state : found->second) {
      note_beyond(state, log_im.back() + kFarScatter * storey.scatter, item.equipment);
      reaches.push_back(reach_of(state, item.equipment));
    }
    const double scatter = storey.scatter, own = std::sqrt(1 - correlation_),
                 common = std::sqrt(correlation_);
    return [=](std::size_t level, const MotionSample& motion, const PieceSample& piece,
               const Replicate& replicate) {
      const double im = log_im[level] + scatter * motion.floor;
      const double score = common * motion.common + own * piece.capacity;
      Reached reached = 0;
      for (const Reach& of : reaches)
        if (of(im, score, replicate.shift)) reached |= of.state;
      return reached;
    };
  }

  std::vector<std::string> cautions() const override {
    std::vector<std::string> all;
    const auto add = [&](const std::map<std::string, std::set<std::string>>& of,
                         const std::string& text) {
      for (const auto& [what, items] : of)
        all.push_back(fmt::format("{}: {} ({})", what, text, fmt::join(items, ", ")));
    };
    add(missing_, "no curve of this limit state, which counts as never reached");
    add(beyond_,
        "beyond the runs of the curves, which are extrapolated; chances of few outcomes are those "
        "at "
        "the highest velocity, where they were at least so large");
    add(loose_,
        "too few runs exceed for a curve, and no table counts them by velocity; the curve is "
        "taken, or "
        "without one the state counts as never reached");
    return all;
  }

 private:
  /// Chances of few outcomes are at most those of the motions just above, as a stronger shaking is no safer; of
  /// none in any run, those of all runs.
  Reach reach_of(const State& state, const std::string& item) const {
    Reach reach{bit(state.name), state.capacity, {}};
    if (!state.few()) return reach;
    if (state.exceed == 0 && state.runs.value_or(0) > 0)
      reach.thresholds.emplace_back(0, threshold(0, *state.runs));
    else
      for (const Count& count : state.counts)
        reach.thresholds.emplace_back(std::log(count.velocity),
                                      threshold(count.exceed, count.motions));
    if (reach.thresholds.empty()) loose_[state.name].insert(item);
    return reach;
  }

  const Threshold& threshold(std::size_t exceed, std::size_t motions) const {
    const auto known = thresholds_.find({exceed, motions});
    return known != thresholds_.end()
               ? known->second
               : thresholds_.emplace(std::pair(exceed, motions), Threshold(exceed, motions))
                     .first->second;
  }

  /// @param log_im  of the highest velocity that is asked for, 1.6 deviations of a scatter above
  void note_beyond(const State& state, double log_im, const std::string& item) const {
    if (!state.counts.empty() && log_im > std::log(state.counts.back().velocity) + kSameVelocity)
      beyond_[fmt::format("{:.3g} m/s", std::exp(log_im))].insert(item);
  }

  /// Limit states with a consequence for the item that none of its curves has.
  void note_missing(const HospitalItem& item, const std::vector<State>& states) const {
    for (std::size_t i = 0; i < consequences_.limit_states().size(); ++i) {
      const LimitState& asked = consequences_.limit_states()[i];
      const std::string& name = asked.name;
      if (consequences_.of(item.equipment, i) == nullptr) continue;
      // An item on the floor has nowhere to fall.
      if (asked.is_simple() && asked.quantity.column == "time_of_fall") continue;
      if (std::ranges::find(states, name, &State::name) != states.end()) continue;
      const std::vector<std::string> known = names_of(states);
      missing_[fmt::format("'{}'{}", name, config::near_name(name, known))].insert(item.equipment);
    }
  }

  Reached bit(const std::string& state) const {
    return Reached{1} << (std::ranges::find(states_, state) - states_.begin());
  }

  [[noreturn]] void refuse(const HospitalItem& item, const Storey& storey, Brakes brakes,
                           const std::string& measure) const {
    std::vector<std::string> items, floors;
    for (const auto& [setting, states] : settings_) {
      items.push_back(std::get<0>(setting));
      floors.push_back(std::get<1>(setting));
    }
    const auto near = [](const std::string& name, std::vector<std::string> known) {
      known.erase(std::unique(known.begin(), known.end()), known.end());
      return config::suggestion(name, known);
    };
    if (std::ranges::find(items, item.equipment) == items.end())
      throw Error(fmt::format("{}: '{}': no curves of this item{}", item.where, item.equipment,
                              near(item.equipment, items)));
    std::ranges::sort(floors);
    if (std::ranges::find(floors, storey.floor) == floors.end())
      throw Error(fmt::format("{}: floor '{}': no curves on it{}", storey.where, storey.floor,
                              near(storey.floor, floors)));
    throw Error(fmt::format("{}: no curves of {} on the floor '{}', {}, brakes {}, over {}",
                            item.where, item.equipment, storey.floor, item.place,
                            brakes_names()[static_cast<std::size_t>(brakes)], measure));
  }

  const Hospital& hospital_;
  double correlation_;
  const Consequences& consequences_;
  States settings_;
  std::vector<std::string> states_;
  // Cautions with the items that they concern, collected as outcomes are asked for.
  mutable std::map<std::string, std::set<std::string>> missing_, beyond_, loose_;
  mutable std::map<std::pair<std::size_t, std::size_t>, Threshold>
      thresholds_;  ///< those asked for
};

}  // namespace

std::unique_ptr<OutcomeSource> curve_outcomes(const Hospital& hospital,
                                              const Consequences& consequences,
                                              double correlation) {
  return std::make_unique<CurveOutcomes>(hospital, consequences, correlation);
}

}  // namespace gurney::study
