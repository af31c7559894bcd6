#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "groundmotions/formats/calendar.h"
#include "groundmotions/formats/fortran_fields.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

constexpr double kTimeRounding = 0.00051;  ///< times have three decimals [s]

class CwbReader : public LayoutReader {
 public:
  using LayoutReader::LayoutReader;

  std::vector<Component> read() {
    std::size_t line = 0;
    const auto rate = value("#SampleRate", line);
    const auto per_second = number(rate);
    time_step_ =
        agreed_time_step(per_second ? std::optional(1 / *per_second) : std::nullopt, line + 1);
    const auto unit_text = value("#AmplitudeUnit", line);
    const AccelerationUnit unit = agreed_unit(unit_in(unit_text), line + 1);
    const auto length = number(value("#RecordLength", length_line_)).value_or(0);
    read_sequence();
    const auto text = value("#Data:", line);
    const auto format = fortran_format(text.substr(0, text.find(' ')));
    if (!format || format->per_line != names_.size() + 1)
      errors_.add(line + 1, 1,
                  fmt::format("'{}' is no format of a time and {} samples", text, names_.size()));
    errors_.throw_if_any();

    const auto columns = read_table(file_, first_row(), *format, errors_);
    errors_.throw_if_any();
    check_times(columns[0], length);
    errors_.throw_if_any();
    std::vector<Component> components;
    for (std::size_t i = 0; i < names_.size(); ++i)
      components.push_back(component(i, unit, columns[i + 1]));
    errors_.throw_if_any();
    return components;
  }

 private:
  struct Name {
    char letter;  ///< 'U', 'N' or 'E'
    bool is_negative;
  };

  static bool is_header(std::string_view line) {
    return trimmed(line).empty() || trimmed(line).starts_with('#');
  }

  std::size_t first_row() const {
    const auto at = std::ranges::find_if_not(file_.lines(), is_header);
    return static_cast<std::size_t>(at - file_.lines().begin());
  }

  /// "Time U(+); N(+); E(+)"
  void read_sequence() {
    std::size_t line = 0;
    const auto text = value("#DataSequence", line);
    bool is_sound = text.starts_with("Time");
    std::string_view rest = text.substr(is_sound ? 4 : 0);
    for (rest = trimmed(rest); !rest.empty() && is_sound; rest = trimmed(rest)) {
      const auto part = trimmed(rest.substr(0, rest.find(';')));
      rest.remove_prefix(std::min(rest.find(';'), rest.size() - 1) + 1);
      is_sound = part.size() == 4 && std::string_view("UNE").find(part[0]) != part.npos &&
                 (part.substr(1) == "(+)" || part.substr(1) == "(-)") &&
                 std::ranges::none_of(names_, [&](const Name& n) { return n.letter == part[0]; });
      if (is_sound) names_.push_back({part[0], part[2] == '-'});
    }
    if (!is_sound || names_.empty())
      errors_.add(line + 1, 1,
                  fmt::format("'{}' is no sequence of Time and U, N, E with their signs", text));
  }

  void check_times(const Eigen::VectorXd& times, double length) {
    check_enough(static_cast<double>(times.size()), 0, errors_);
    if (errors_.any()) return;
    for (Eigen::Index i = 0; i < times.size(); ++i) {
      const double even = times[0] + static_cast<double>(i) * time_step_;
      if (!(std::abs(times[i] - even) <= 2 * kTimeRounding)) {
        errors_.add(
            first_row() + static_cast<std::size_t>(i) + 1, 1,
            fmt::format("time {} s where the sampling rate gives {:.6g} s", times[i], even));
        return;
      }
    }
    const double found = static_cast<double>(times.size()) * time_step_;
    if (!(std::abs(found - length) <= 1 + 1e-9))  // stated in whole seconds
      errors_.add(length_line_ + 1, 1,
                  fmt::format("the header states a length of {} s, but {} rows at {} s have "
                              "{:.6g} s",
                              length, times.size(), time_step_, found));
    else if (std::abs(found - length) > 0.5 * time_step_)
      warning_ =
          fmt::format("the header states a length of {} s, but {} rows at {} s have {:.6g} s",
                      length, times.size(), time_step_, found);
  }

  Component component(std::size_t i, const AccelerationUnit& unit, const Eigen::VectorXd& samples) {
    const auto& [letter, is_negative] = names_[i];
    Component component;
    component.name = letter;
    component.time_step = time_step_;
    component.unit = unit.name;
    component.acceleration = unit.to_si * samples;
    if (!warning_.empty()) component.warnings.push_back(warning_);
    check_stated_peak(letter, unit, component);
    if (is_negative && letter != 'U') {
      component.acceleration = -component.acceleration;
      component.warnings.push_back(fmt::format("{}(-): the sign was turned, {} is positive", letter,
                                               letter == 'N' ? "north" : "east"));
    }
    if (is_negative && letter == 'U')
      turn_up("U(-)", component);
    else
      orient_by_label(letter == 'U' ? "UP" : std::string(1, letter), component);
    describe(component);
    return component;
  }

  /// "#AmplitudeMAX. U:    0.658~   -0.837"
  void check_stated_peak(char letter, const AccelerationUnit& unit, Component& component) {
    std::size_t line = 0;
    auto text =
        value_behind(file_.lines(), fmt::format("#AmplitudeMAX. {}", letter), line).value_or("");
    const double rounding = 1.1 * rounding_of(text);
    const auto largest = take_number(text);
    text.remove_prefix(std::min(text.find_first_of("-+0123456789."), text.size()));
    const auto smallest = take_number(text);
    if (largest && smallest)
      check_peak({std::max(std::abs(*largest), std::abs(*smallest)) * unit.to_si,
                  rounding * unit.to_si, line + 1},
                 component);
  }

  void describe(Component& component) {
    state_facts({{"station", "#StationName"},
                 {"station code", "#StationCode"},
                 {"event", "#Origin Time"},
                 {"magnitude", "#Magnitude"},
                 {"unit", "#AmplitudeUnit"},
                 {"instrument", "#InstrumentKind"}},
                component);
    component.start_time = start_time();
  }

  /// "#StartTime(GMT+08): 2018/02/06-23:50:29.000"
  std::optional<double> start_time() const {
    std::size_t line = 0;
    const auto text = value_behind(file_.lines(), "#StartTime(GMT", line);
    if (!text) return {};
    const auto zone = number_after(file_.lines()[line], "GMT");
    const auto local = utc_seconds(*text);
    if (!local || !zone || !(std::abs(*zone) <= 14)) return {};
    return *local - 3600 * *zone;
  }

  double time_step_ = 0;
  std::size_t length_line_ = 0;
  std::vector<Name> names_;
  std::string warning_;  ///< of every component
};

}  // namespace

bool recognises_cwb(const SourceFile& file) {
  bool has_station = false, has_sequence = false;
  const auto& lines = file.lines();
  for (std::size_t i = 0; i < std::min<std::size_t>(60, lines.size()); ++i) {
    has_station = has_station || trimmed(lines[i]).starts_with("#StationCode");
    has_sequence = has_sequence || trimmed(lines[i]).starts_with("#DataSequence");
  }
  return has_station && has_sequence;
}

/// @throws Error for statements that are missing or disagree, times that are not evenly spaced, a
///         length that differs from the stated one by more than a second, and samples that are no
///         numbers.
std::vector<Component> read_cwb(const SourceFile& file, const ReadOptions& options) {
  FileErrors errors(file);
  return CwbReader(file, options, errors).read();
}

}  // namespace gurney::groundmotions
