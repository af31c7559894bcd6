#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"
#include "groundmotions/formats/calendar.h"
#include "groundmotions/formats/cosmos_channel.h"
#include "groundmotions/formats/cosmos_codes.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

constexpr double kMillisecond = 1e-3;
constexpr double kMicrovolt = 1e-6;
constexpr double kPeakRounding = 5e-4;  ///< of the peak: three digits and more are printed
constexpr double kSameStep = 1e-6;      ///< share by which two statements of a time step may differ
constexpr double kSameFactor = 0.01;    ///< the like of the value of a count

/// Quantity of a series: its own line says it, or else the header; "acceleration" if a record.
std::string quantity_of(const CosmosChannel& channel, const CosmosSeries& series) {
  const int code = static_cast<int>(channel.integer(2).value_or(0));
  const char* stated = cosmos_quantity(code);
  if (stated && code != 1) return stated;
  if (series.text.find("VEL") != kNone) return "velocity";
  if (series.text.find("DIS") != kNone) return "displacement";
  if (series.text.find("ACC") != kNone || stated) return "acceleration";
  return "something its header does not name";
}

class ChannelReader {
 public:
  ChannelReader(const SourceFile& file, const ReadOptions& options, FileErrors& errors)
      : file_(file), options_(options), errors_(errors) {}

  Component component_of(const CosmosChannel& channel, const CosmosSeries& series) {
    line_ = series.line + 1;
    Component component;
    const double to_si = si_of(channel, series, component);
    component.time_step = time_step_of(channel, component);
    component.acceleration = scaled(series.values, to_si);
    check_holes(channel, series);
    if (errors_.any()) return component;
    check_length(channel.real(63).value_or(0), line_, component, errors_);
    if (const auto peak = channel.real(64); peak && *peak != 0) {
      const double size = std::abs(*peak) * to_si;
      check_peak({size, kPeakRounding * size, line_}, component.acceleration, component, errors_);
    }
    orient(channel, component);
    state_facts(channel, component);
    return component;
  }

 private:
  double si_of(const CosmosChannel& channel, const CosmosSeries& series, Component& component) {
    const auto header = channel.integer(3);
    const int code = series.unit_code.value_or(static_cast<int>(header.value_or(0)));
    if (header && *header != code) state_other_unit(static_cast<int>(*header), code, component);
    if (code == kCosmosCounts) return si_per_count(channel, component);
    if (options_.si_per_count)
      errors_.add(line_, 1,
                  fmt::format("count_m_per_s2 was given, but the samples are not counts (unit code "
                              "{})",
                              code));
    auto unit = cosmos_unit(code);
    if (!unit && code > 0)
      errors_.add(line_, 1,
                  fmt::format("unit code {} is no unit of acceleration (2 is g, 4 cm/s2, 7 in/s2, "
                              "10 gal, 11 mg, 12 micro g, 50 counts)",
                              code));
    else
      unit = agreed_unit(unit, line_, options_, errors_);
    component.unit = unit ? unit->name : "";
    return unit ? unit->to_si : 0;
  }

  /// Another unit of acceleration would be another motion; what is none cannot be meant.
  void state_other_unit(int header, int code, Component& component) {
    const std::string text = fmt::format(
        "the line of the samples states the unit code {}, but integer 3 of the header {}", code,
        header);
    if (cosmos_unit(header) || header == kCosmosCounts)
      errors_.add(line_, 1, text);
    else
      component.warnings.push_back(text + ", which is no unit of acceleration");
  }

  /// A count is (real 22, microvolts) / (real 42, volts per g) / (real 47, gain) g.
  double si_per_count(const CosmosChannel& channel, Component& component) {
    component.unit = "counts";
    if (!options_.unit.empty())
      errors_.add(line_, 1,
                  fmt::format("unit = \"{}\" was given, but the samples are raw counts (unit code "
                              "{})",
                              options_.unit, kCosmosCounts));
    const auto volts = channel.real(22), sensitivity = channel.real(42);
    const double gain = channel.real(47).value_or(1);
    double stated = 0;
    if (volts && sensitivity && *volts > 0 && *sensitivity > 0 && gain > 0)
      stated = *volts * kMicrovolt / (*sensitivity * gain) * kStandardGravity;
    if (const auto given = options_.si_per_count) {
      if (stated > 0 && std::abs(*given - stated) > kSameFactor * stated)
        component.warnings.push_back(fmt::format(
            "count_m_per_s2 = {:.6g} was taken, but the header states {:.6g} m/s2 for a count",
            *given, stated));
      return *given;
    }
    if (!(stated > 0)) {
      errors_.add(
          line_, 1,
          "the samples are raw counts, and the header states no sensitivity (real numbers "
          "22, 42 and 47); state count_m_per_s2 or gurney records --count, or take the .V1c or "
          ".V2c of this "
          "record");
      return 0;
    }
    component.warnings.push_back(fmt::format(
        "raw counts (V0) were taken as {:.6g} m/s2 each, from the header: {} microvolts, {} V/g, "
        "gain {}; their offset is still in",
        stated, *volts, *sensitivity, gain));
    return stated;
  }

  double time_step_of(const CosmosChannel& channel, Component& component) {
    auto step = channel.real(62);  // of these samples, in ms
    const auto raw = channel.real(34);
    if (step)
      *step *= kMillisecond;
    else if ((step = raw))
      component.warnings.push_back(
          "real number 62 of the header states no time step; that of the raw samples (34) was "
          "taken");
    if (step && raw && *raw > 0 && std::abs(*raw - *step) > kSameStep * *raw)
      component.warnings.push_back(
          fmt::format("the header states two time steps: {} s (real number 62, of these samples; "
                      "taken) and {} s (34, of the raw samples)",
                      *step, *raw));
    return agreed_time_step(step, line_, options_, errors_);
  }

  /// Samples that are the value for "unknown" are holes, unless the motion passes through it.
  void check_holes(const CosmosChannel& channel, const CosmosSeries& series) {
    const double hole = channel.unknown_real;
    const auto& values = series.values;
    const auto is_far = [&](double value) { return std::abs(value - hole) > 0.5 * std::abs(hole); };
    for (std::size_t i = 0; i < values.size(); ++i)
      if (values[i] == hole &&
          ((i > 0 && is_far(values[i - 1])) || (i + 1 < values.size() && is_far(values[i + 1]))))
        return errors_.add(line_, 1,
                           fmt::format("sample {} of {} is {}, which stands for an unknown value",
                                       i + 1, values.size(), hole));
  }

  /// "Sta Chan  1: 360 deg (Rcrdr Chan  1) Location: ..."
  std::string label_of(const CosmosChannel& channel) const {
    for (std::size_t i = 0; i < channel.text.size(); ++i) {
      if (!channel.text[i].starts_with("STA CHA")) continue;
      auto line = file_.lines()[channel.first_line + i];
      line = line.substr(0, std::min(line.find('('), channel.text[i].find("LOCATION")));
      return std::string(trimmed(line.substr(line.rfind(':') + 1)));
    }
    return {};
  }

  /// "Location: ..." of the line of the channel and the recorder's serial number.
  void state_place(const CosmosChannel& channel, Component& component) const {
    constexpr std::string_view kLocation = "LOCATION:";
    for (std::size_t i = 0; i < channel.text.size(); ++i) {
      const auto at = channel.text[i].find(kLocation);
      if (!channel.text[i].starts_with("STA CHA") || at == kNone) continue;
      const auto place =
          trimmed(file_.lines()[channel.first_line + i].substr(at + kLocation.size()));
      if (!place.empty()) component.header.emplace_back("location", place);
    }
    const auto serial =
        channel.text.size() > 6 ? number_after(channel.text[6], "S/N") : std::optional<double>();
    if (serial) component.header.emplace_back("recorder", fmt::format("s/n {:.0f}", *serial));
  }

  void orient_by_text(const CosmosChannel& channel, Component& component) const {
    if (!orient_by_label(component.name, component)) orient_by_label(channel.code, component);
  }

  void orient(const CosmosChannel& channel, Component& component) {
    component.name = label_of(channel);
    if (component.name.empty()) component.name = channel.code;
    const auto north = channel.integer(54), reference = channel.integer(55);
    const int code = static_cast<int>(north.value_or(reference.value_or(0)));
    if (code == kCosmosUp || code == kCosmosVertical) {
      component.direction = Direction::kVertical;
    } else if (code == kCosmosDown) {
      turn_up("code 401", component);
    } else if (const char* meaning = cosmos_orientation(code)) {
      component.header.emplace_back("orientation", meaning);
    } else if (north && *north >= 1 && *north <= 360) {
      component.azimuth = std::fmod(*north, 360) * kRadiansPerDegree;
    } else if (reference) {
      component.warnings.push_back(
          fmt::format("the sensor lies {} degrees from a reference direction (integer 55 of the "
                      "header), not from north: its azimuth is not known",
                      *reference));
      return;
    } else {
      orient_by_text(channel, component);
      return;
    }
    Component by_label;
    by_label.acceleration = Eigen::VectorXd::Zero(2);
    by_label.name = component.name;
    orient_by_text(channel, by_label);
    const bool other_kind = component.direction != by_label.direction;
    const bool other_azimuth = component.azimuth && by_label.azimuth &&
                               std::abs(*component.azimuth - *by_label.azimuth) > kRadiansPerDegree;
    if ((by_label.azimuth || by_label.direction) && (other_kind || other_azimuth))
      component.warnings.push_back(fmt::format(
          "integer 54 of the header states orientation {}, which was taken, but the text "
          "'{}'",
          code, component.name));
  }

  void state_facts(const CosmosChannel& channel, Component& component) const {
    const auto state = [&](const char* name, std::size_t index) {
      if (index < channel.text.size())
        component.header.emplace_back(name, trimmed(file_.lines()[channel.first_line + index]));
    };
    state("stage", 0);
    state("event", 1);
    state("station", 4);
    state("peak", 10);
    state("filter", 11);
    state_place(channel, component);
    if (const char* structure = cosmos_structure(static_cast<int>(channel.integer(19).value_or(0))))
      component.header.emplace_back("structure", structure);
    const auto part = [&](std::size_t number) {
      return static_cast<int>(channel.integer(number).value_or(-1));
    };
    if (const auto second = channel.real(30); second && part(42) > 0 && part(43) > 0)
      component.start_time = utc_seconds(part(40), part(42), part(43), part(44), part(45), *second);
  }

  const SourceFile& file_;
  const ReadOptions& options_;
  FileErrors& errors_;
  std::size_t line_ = 1;
};

bool holds_spectra(const SourceFile& file) {
  const std::string first = upper(file.lines()[0].substr(0, 200));
  return first.find("SPECTR") != kNone || first.find("RESPONSE") != kNone;
}

}  // namespace

bool recognises_cosmos(const SourceFile& file) { return starts_cosmos_channel(file.lines()[0]); }

/// @returns the channels of acceleration. Raw counts are converted by options.si_per_count, or else
///          by the sensitivity of the sensor and the recorder that the header states.
/// @throws Error for spectra (V3), files without acceleration, units that are not acceleration,
///         counts without a sensitivity, and samples that are not as many as stated.
std::vector<Component> read_cosmos(const SourceFile& file, const ReadOptions& options) {
  FileErrors errors(file);
  if (holds_spectra(file)) refuse_spectra(file.name(), "V3", "the V2");
  const auto channels = cosmos_channels(file, errors);
  errors.throw_if_any();
  std::vector<Component> components;
  std::string others;
  ChannelReader reader(file, options, errors);
  for (const CosmosChannel& channel : channels) {
    for (const CosmosSeries& series : channel.series) {
      const std::string quantity = quantity_of(channel, series);
      if (quantity == "acceleration")
        components.push_back(reader.component_of(channel, series));
      else if (others.find(quantity) == std::string::npos)
        others += (others.empty() ? "" : ", ") + quantity;
    }
  }
  if (components.empty())
    errors.add(1, 1,
               fmt::format("a record must be acceleration, but this file holds {}; take the "
                           "acceleration file of this record (.V1c, .acc.V2c)",
                           others));
  errors.throw_if_any();
  if (!others.empty())
    for (Component& component : components)
      component.header.emplace_back("also in the file", others);
  return components;
}

}  // namespace gurney::groundmotions
