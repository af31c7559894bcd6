#include "groundmotions/formats/caltech_components.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "groundmotions/formats/calendar.h"
#include "groundmotions/formats/caltech_volume.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/uneven_samples.h"
#include "groundmotions/formats/unit_text.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

constexpr double kGrid = 1e-6;              ///< printed times on an even grid differ by less [s]
constexpr double kPeakOfVolume1 = 0.00056;  ///< printed to 0.001 g, the samples to 0.0001 g [g]
constexpr double kPeakOfVolume2 = 1.1e-5;   ///< both are printed to 0.001 cm/s2 [m/s2]
constexpr double kPeakTooFar = 0.1;         ///< of the peak; an assumption
constexpr double kPeakShare = 1e-4;         ///< of large peaks with fewer digits after the point

using Quantity = CaltechSeries::Quantity;

class ChannelReader {
 public:
  ChannelReader(const SourceFile& file, const ReadOptions& options, FileErrors& errors)
      : file_(file), options_(options), errors_(errors) {}

  Component component_of(const CaltechChannel& channel) {
    Component component;
    const auto series =
        std::ranges::find(channel.series, Quantity::kAcceleration, &CaltechSeries::quantity);
    if (series == channel.series.end()) {
      errors_.add(channel.first_line + 1, 1,
                  "this channel holds velocity or displacement only; a record must be "
                  "acceleration");
      return component;
    }
    const AccelerationUnit unit = unit_of(channel, *series, component);
    component.unit = unit.name;
    take_samples(channel, *series, component);
    if (errors_.any()) return component;
    component.acceleration *= unit.to_si;
    check_length(channel.reals[channel.corrected() ? 59 : 2], channel.first_line + 1, component,
                 errors_);
    check_step(channel, component);
    check_peak_of(channel, *series, unit.to_si, component);
    if (!channel.trailing.empty())
      component.warnings.push_back(
          fmt::format("the last line of the file is no part of the format and was ignored: '{}'",
                      channel.trailing.substr(0, 60)));
    orient(channel, component);
    state_facts(channel, component);
    return component;
  }

 private:
  std::size_t line_of(const CaltechChannel& channel, std::optional<std::size_t> index) const {
    return channel.first_line + index.value_or(0) + 1;
  }

  AccelerationUnit unit_of(const CaltechChannel& channel, const CaltechSeries& series,
                           Component& component) {
    if (series.unit) return agreed_unit(series.unit, series.line + 1, options_, errors_);
    const auto at = channel.find(channel.corrected() ? "PEAK ACCELERATION" : "UNITS");
    const auto stated = at ? unit_in(channel.text[*at]) : std::nullopt;
    const double fraction = channel.reals[4];  // of g, in volume 1; some files state 1 for g/10
    if (stated && !channel.corrected() && fraction > 0 &&
        std::abs(fraction * kStandardGravity - stated->to_si) > 1e-3 * stated->to_si)
      component.warnings.push_back(
          fmt::format("the text states the unit {}, which was taken, but real number 5 of the "
                      "header {} g",
                      stated->name, fraction));
    return agreed_unit(stated, line_of(channel, at), options_, errors_);
  }

  void take_samples(const CaltechChannel& channel, const CaltechSeries& series,
                    Component& component) {
    std::vector<double> values = series.values;
    component.acceleration =
        Eigen::Map<Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
    if (series.times.empty()) {
      auto step = series.time_step;
      if (!step && channel.corrected() && channel.reals[60] > 0) step = channel.reals[60];
      component.time_step = agreed_time_step(step, series.line + 1, options_, errors_);
      return;
    }
    if (series.times.size() < 2) return;
    if (spacing_of(series.times).even(kGrid)) {
      const double mean = (series.times.back() - series.times.front()) /
                          static_cast<double>(series.times.size() - 1);
      const double step = std::round(mean / kGrid) * kGrid;
      component.time_step = agreed_time_step(step, series.line + 1, options_, errors_);
      return;
    }
    component.time_step = options_.time_step.value_or(kEvenTimeStep);
    try {
      component.acceleration = evenly_spaced(series.times, values, component.time_step);
      component.warnings.push_back(uneven_warning(series.times, component.time_step));
    } catch (const Error& error) {
      errors_.add(series.line + 1, 1, error.what());
    }
  }

  void check_step(const CaltechChannel& channel, Component& component) const {
    const double step = channel.corrected() ? channel.reals[60] : 0;
    if (step > 0 && std::abs(step - component.time_step) > 1e-3 * step)
      component.warnings.push_back(
          fmt::format("real number 61 of the header states a time step of {} s, but the line above "
                      "the samples {} s, which was taken",
                      step, component.time_step));
  }

  void check_peak_of(const CaltechChannel& channel, const CaltechSeries& series, double to_si,
                     Component& component) {
    const bool corrected = channel.corrected();
    const auto at = channel.find(corrected ? "PEAK ACCELERATION" : "UNITS OF UNCOR");
    const auto peak = at ? number_after(channel.text[*at], corrected ? "PEAK ACCELERATION" : "MAX")
                         : std::nullopt;
    if (!peak) return;
    const double size = std::abs(*peak) * (corrected ? 0.01 : kStandardGravity);
    const double rounding = corrected ? kPeakOfVolume2 : kPeakOfVolume1 * kStandardGravity;
    const Eigen::VectorXd samples = scaled(series.values, to_si);
    check_peak({size, std::max(rounding, kPeakShare * size), line_of(channel, at)}, samples,
               component, errors_);
    const double raw = samples.cwiseAbs().maxCoeff();
    const double centred = (samples.array() - samples.mean()).abs().maxCoeff();
    const double difference = std::min(std::abs(raw - size), std::abs(centred - size));
    if (difference > kPeakTooFar * size + rounding && !errors_.any())
      errors_.add(line_of(channel, at), 1,
                  fmt::format("the header states a peak of {:.5g} m/s2, but the samples have "
                              "{:.5g} m/s2: one of them is damaged",
                              size, raw));
  }

  /// "CHAN  1:  90 DEG  (STA CHN: 14)", "Chan  1: Up   Location: Roof" of CSMIP, "COMP N08W" of
  /// USC.
  std::string label_of(const CaltechChannel& channel) const {
    for (std::size_t i = 0; i < channel.text.size(); ++i) {
      const auto line = trimmed(file_.lines()[channel.first_line + i]);
      const std::string text = upper(line);
      if (text.starts_with("CHAN") && text.find(':') != kNone) {
        const auto begin = line.find(':') + 1;
        const auto end = std::min(line.find('(', begin), text.find("LOCATION", begin));
        return std::string(trimmed(line.substr(begin, end - begin)));
      }
      if (text.starts_with("COMP ")) {
        const auto label = trimmed(line.substr(5));
        return std::string(label.substr(0, label.find("  ")));
      }
    }
    return {};
  }

  /// Integer 27 is the azimuth, 500 for up or 600 for down; 0 also where it is not known.
  void orient(const CaltechChannel& channel, Component& component) {
    component.name = label_of(channel);
    const double code = channel.integers[26];
    if (!orient_by_label(component.name, component)) {
      if (code >= 1 && code <= 360)
        component.azimuth = std::fmod(code, 360) * kRadiansPerDegree;
      else if (code == 500)
        component.direction = Direction::kVertical;
      else if (code == 600)
        turn_up("integer 27 of the header is 600", component);
    } else if (component.azimuth && code >= 1 && code <= 360 &&
               std::abs(std::remainder(code * kRadiansPerDegree - *component.azimuth,
                                       360 * kRadiansPerDegree)) > kRadiansPerDegree) {
      component.warnings.push_back(fmt::format(
          "integer 27 of the header states an azimuth of {} degrees, but the text '{}', "
          "which was taken",
          code, component.name));
    }
  }

  void state_facts(const CaltechChannel& channel, Component& component) const {
    const bool corrected = channel.corrected();
    const auto state = [&](const char* name, std::size_t index) {
      if (index >= channel.text.size()) return;
      const auto text = trimmed(file_.lines()[channel.first_line + index]);
      if (!text.empty()) component.header.emplace_back(name, text);
    };
    component.header.emplace_back("volume", corrected ? "2 (corrected)" : "1 (uncorrected)");
    state("event", corrected ? 2 : 1);
    state("station", corrected ? 6 : 5);
    state("station line", corrected ? 5 : 4);
    for (const auto& [name, key] :
         {std::pair{"filter", "FILTERED"}, std::pair{"peak", "UNITS OF UNCOR"},
          std::pair{"peak", "PEAK ACCEL"}, std::pair{"trigger", "TRIGGER TIME"}})
      if (const auto at = channel.find(key)) state(name, *at);
    state_place(channel, component);
    if (channel.series.size() > 1)
      component.header.emplace_back("also in the file", "velocity, displacement");
    if (const auto at = channel.find("START TIME"))
      component.start_time =
          time_in(channel.text[*at].substr(channel.text[*at].find("START TIME")));
  }

  /// "Chan  4: 90 Deg  Location: Roof - N wall" and the recorder of "SMA-1 S/N 5254".
  void state_place(const CaltechChannel& channel, Component& component) const {
    constexpr std::string_view kLocation = "LOCATION:";
    if (const auto at = channel.find(kLocation)) {
      const auto line = file_.lines()[channel.first_line + *at];
      const auto place = line.substr(channel.text[*at].find(kLocation) + kLocation.size());
      if (!trimmed(place).empty()) component.header.emplace_back("location", trimmed(place));
    }
    const std::size_t index = channel.corrected() ? 5 : 4;
    const auto serial = index < channel.text.size() ? number_after(channel.text[index], "S/N")
                                                    : std::optional<double>();
    if (serial) component.header.emplace_back("recorder", fmt::format("s/n {:.0f}", *serial));
  }

  /// "START TIME:  8/29/18, 02:33:  .0 UTC": month, day, year.
  static std::optional<double> time_in(std::string text) {
    double offset = 0;  // hours to UTC
    if (text.find("PDT") != kNone) offset = 7;
    if (text.find("PST") != kNone) offset = 8;
    if (offset == 0 && text.find("UTC") == kNone && text.find("GMT") == kNone) return {};
    text = text.substr(std::string_view("START TIME").size());
    std::ranges::replace_if(
        text, [](char c) { return c == '/' || c == ':' || c == ','; }, ' ');
    double parts[6];
    std::string_view rest = text;
    for (double& part : parts) {
      rest = trimmed(rest);
      const auto value = take_number(rest);
      if (!value || !(*value >= 0 && *value < 10000)) return {};
      part = *value;
    }
    const int year = static_cast<int>(parts[2]);
    const int century = year >= 100 ? 0 : year >= 30 ? 1900 : 2000;
    const auto time = utc_seconds(century + year, static_cast<int>(parts[0]),
                                  static_cast<int>(parts[1]), parts[3], parts[4], parts[5]);
    return time ? std::optional(*time + 3600 * offset) : std::nullopt;
  }

  const SourceFile& file_;
  const ReadOptions& options_;
  FileErrors& errors_;
};

}  // namespace

std::vector<Component> caltech_components(const SourceFile& file, const ReadOptions& options) {
  FileErrors errors(file);
  const auto channels = caltech_channels(file, errors);
  errors.throw_if_any();
  std::vector<Component> components;
  ChannelReader reader(file, options, errors);
  for (const CaltechChannel& channel : channels) components.push_back(reader.component_of(channel));
  errors.throw_if_any();
  return components;
}

}  // namespace gurney::groundmotions
