#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <tuple>

#include "engine/base/csv_row.h"
#include "engine/base/error.h"
#include "engine/base/input_file.h"
#include "engine/base/number_text.h"
#include "engine/config/nearest_name.h"
#include "equipment/catalogue/data_folder.h"
#include "studies/hospital/outcomes.h"

namespace gurney::study {
namespace {

constexpr const char *kFloorVelocity = "pfv", *kGroundVelocity = "PGV larger";
constexpr double kNormal95 = 1.959963984540054;

/// A capacity of ln theta + beta z, and the standard error of ln theta.
struct Capacity {
  double log_theta, beta, error;
};

/// Equipment, floor, place, brakes, measure.
using Setting = std::tuple<std::string, std::string, std::string, std::string, std::string>;

struct State {
  std::string name;
  std::optional<Capacity> capacity;  ///< none: no run reaches it
};

/// A table in the columns of docs/catalogue/data/fragility.csv.
class CurveFile {
 public:
  CurveFile(const std::string& path, std::map<Setting, std::vector<State>>& into)
      : path_(path), into_(into) {
    std::istringstream text(read_input_file(path));
    std::string line;
    while (std::getline(text, line)) {
      ++line_;
      if (trimmed(line).empty()) continue;
      cells_ = csv_row(line);
      if (columns_.empty())
        take_titles();
      else
        take_row();
    }
  }

 private:
  [[noreturn]] void fail(std::size_t column, const std::string& message) const {
    throw Error(fmt::format("{}:{}:{}: {}", path_, line_, column, message));
  }

  void take_titles() {
    for (std::size_t i = 0; i < cells_.size(); ++i) columns_[cells_[i].text] = i;
    for (const char* name : {"item", "floor", "place", "brakes", "limit_state", "measure", "theta",
                             "theta_low", "theta_high", "beta", "reason"})
      if (!columns_.contains(name)) fail(1, fmt::format("no column '{}'", name));
  }

  const std::string& text(const char* column) const {
    const std::size_t i = columns_.at(column);
    if (i >= cells_.size()) fail(1, fmt::format("no value in the column '{}'", column));
    return cells_[i].text;
  }

  std::optional<double> value(const char* column) const {
    const std::string& cell = text(column);
    if (cell.empty() || cell == "inf") return {};
    const std::optional<double> found = number(cell);
    if (!found || *found < 0)
      fail(cells_[columns_.at(column)].column,
           fmt::format("{} = '{}': must be a number >= 0", column, cell));
    return found;
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

  /// Without a curve the likelihood is highest for a step: where outcomes are separated at the
  /// intensity that the reason names, or between two; nowhere if no run exceeds.
  std::optional<Capacity> step() const {
    std::string_view reason = text("reason");
    if (reason.starts_with("no run exceeds") || reason.empty()) return {};
    std::vector<double> named;
    while (!reason.empty()) {
      if (reason.front() >= '0' && reason.front() <= '9') {
        if (const auto found = take_number(reason)) named.push_back(*found);
      } else {
        reason.remove_prefix(1);
      }
    }
    if (named.empty() || !(named.front() > 0)) return {};
    const double theta = named.size() > 1 ? std::sqrt(named[0] * named[1]) : named[0];
    return Capacity{std::log(theta), 0, 0};
  }

  void take_row() {
    const std::optional<double> theta = value("theta"), beta = value("beta");
    State state{text("limit_state"), {}};
    if (theta && beta && *theta > 0 && *beta > 0)
      state.capacity = Capacity{std::log(*theta), *beta, error_of(*theta)};
    else
      state.capacity = step();
    into_[{text("item"), text("floor"), text("place"), text("brakes"), text("measure")}].push_back(
        std::move(state));
  }

  std::string path_;
  std::map<Setting, std::vector<State>>& into_;
  std::map<std::string, std::size_t> columns_;
  std::vector<CsvCell> cells_;
  std::size_t line_ = 0;
};

class CurveOutcomes : public OutcomeSource {
 public:
  CurveOutcomes(const Hospital& hospital, const Consequences& consequences, double correlation)
      : hospital_(hospital), correlation_(correlation) {
    std::vector<std::string> files = hospital.curves;
    const std::string data = equipment::find_data_folder().path + "/docs/catalogue/data/";
    if (files.empty()) files = {data + "fragility.csv", data + "more_states.csv"};
    for (const std::string& file : files) CurveFile(file, settings_);
    for (const LimitState& state : consequences.limit_states()) states_.push_back(state.name);
    for (const auto& [setting, states] : settings_)
      for (const State& state : states)
        if (std::ranges::find(states_, state.name) == states_.end()) states_.push_back(state.name);
    require(states_.size() <= kMostStates, fmt::format("{}: {} limit states; at most {}",
                                                       hospital.path, states_.size(), kMostStates));
  }

  const std::vector<std::string>& states() const override { return states_; }

  Outcome outcome(const HospitalItem& item, const Storey& storey, Brakes brakes) const override {
    const char* const measure = storey.amplification ? kFloorVelocity : kGroundVelocity;
    const auto found = settings_.find({item.equipment, storey.floor, item.place,
                                       brakes_names()[static_cast<std::size_t>(brakes)], measure});
    if (found == settings_.end()) refuse(item, storey, brakes, measure);
    std::vector<std::pair<Reached, Capacity>> capacities;
    for (const State& state : found->second)
      if (state.capacity) capacities.emplace_back(bit(state.name), *state.capacity);
    std::vector<double> log_im;
    for (const double level : hospital_.levels)
      log_im.push_back(std::log(level * storey.amplification.value_or(1)));
    const double scatter = storey.scatter, own = std::sqrt(1 - correlation_),
                 common = std::sqrt(correlation_);
    return [=](std::size_t level, const MotionSample& motion, const PieceSample& piece,
               const Replicate& replicate) {
      const double im = log_im[level] + scatter * motion.floor;
      const double score = common * motion.common + own * piece.capacity;
      Reached reached = 0;
      for (const auto& [state, of] : capacities)
        if (im > of.log_theta + of.error * replicate.shift + of.beta * score) reached |= state;
      return reached;
    };
  }

 private:
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
  std::map<Setting, std::vector<State>> settings_;
  std::vector<std::string> states_;
};

}  // namespace

std::unique_ptr<OutcomeSource> curve_outcomes(const Hospital& hospital,
                                              const Consequences& consequences,
                                              double correlation) {
  return std::make_unique<CurveOutcomes>(hospital, consequences, correlation);
}

}  // namespace gurney::study
