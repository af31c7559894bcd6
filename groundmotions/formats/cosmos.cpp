#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/base/units.h"
#include "groundmotions/formats/calendar.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

// Codes of the COSMOS Strong Motion Data Format, version 1.20 (2001).

constexpr int kCounts = 50;                             // table 2
constexpr int kUp = 400, kDown = 401, kVertical = 402;  // table 8

struct Code {
  int code;
  const char* meaning;
};

/// Table 1, integer 2 of the header: what was measured.
constexpr Code kQuantities[] = {{1, "acceleration"},          {2, "velocity"},
                                {3, "absolute displacement"}, {4, "relative displacement"},
                                {10, "angular acceleration"}, {11, "angular velocity"},
                                {12, "angular displacement"}, {20, "absolute pressure"},
                                {21, "relative pressure"},    {30, "volumetric strain"},
                                {31, "linear strain"}};

/// Table 6, integer 19: the structure that a station is in; none in the free field.
constexpr Code kStructures[] = {{5, "the base of a building"},
                                {10, "a building"},
                                {11, "a bridge"},
                                {12, "a dam"},
                                {13, "a wharf"},
                                {14, "a tunnel"},
                                {15, "a lifeline structure"},
                                {20, "a structure"}};

/// Table 8: what a code above 360 says of a sensor's orientation.
constexpr Code kOrientations[] = {{kUp, "up"},
                                  {kDown, "down"},
                                  {kVertical, "vertical, its sense not stated"},
                                  {500, "radial, inward"},
                                  {501, "transverse, 90 degrees clockwise from radial"},
                                  {600, "longitudinal, relative to the structure"},
                                  {601, "tangential, relative to the structure"},
                                  {700, "H1, azimuth unknown"},
                                  {701, "H2, azimuth unknown"},
                                  {2000, "other, described in the comments"}};

/// @returns nullptr for an unknown code
const char* meaning(std::span<const Code> codes, int code) {
  const auto found = std::ranges::find(codes, code, &Code::code);
  return found == codes.end() ? nullptr : found->meaning;
}

/// Table 2: units of acceleration of integer 3 of the header; nothing for all others.
std::optional<AccelerationUnit> unit_of_code(int code) {
  constexpr double kMetersPerInch = 0.0254;  // international inch, exact
  switch (code) {
    case 2:
      return AccelerationUnit{"g", kStandardGravity};
    case 4:
    case 10:
      return AccelerationUnit{"cm/s2", 0.01};
    case 7:
      return AccelerationUnit{"in/s2", kMetersPerInch};
    case 11:
      return AccelerationUnit{"mg", 1e-3 * kStandardGravity};
    case 12:
      return AccelerationUnit{"micro g", 1e-6 * kStandardGravity};
    default:
      return {};
  }
}

/// The samples of a channel and the line that announces them: "7000 raw acceleration pts, approx
/// 70 secs, units=cm/sec2(04),Format=(8f10.3)".
struct Series {
  std::size_t line = 0;          ///< index from 0 of that line
  std::string text;              ///< that line, in capitals
  std::optional<int> unit_code;  ///< in its brackets
  std::vector<double> values;
};

std::optional<double> known(const std::vector<double>& values, std::size_t number, double unknown) {
  if (number > values.size()) return {};
  const double value = values[number - 1];
  return std::isnan(value) || value == unknown ? std::nullopt : std::optional(value);
}

/// One channel of a COSMOS file as it stands there: text, integer and real header, comments,
/// series.
struct Channel {
  std::size_t first_line = 0;     ///< index from 0
  std::vector<std::string> text;  ///< in capitals
  std::vector<double> integers, reals;
  double unknown_integer = -999, unknown_real = -999;  ///< what stands for "unknown"
  std::string code;            ///< SEED code of "<SCNL>STATION.CODE.NETWORK.LOCATION"; may be empty
  std::vector<Series> series;  ///< at least one

  /// A number of the header, counted from 1 as the format's definition does; nothing if it is not
  /// known.
  std::optional<double> integer(std::size_t number) const {
    return known(integers, number, unknown_integer);
  }
  std::optional<double> real(std::size_t number) const {
    return known(reals, number, unknown_real);
  }
};

/// The format behind "Format=" of a line in capitals.
std::optional<FortranFormat> format_in(std::string_view text) {
  const auto at = text.rfind("FORMAT");
  if (at == kNone) return {};
  const auto open = text.find('(', at);
  if (open == kNone) return {};
  return fortran_format(text.substr(open, text.find(')', open) - open + 1));
}

/// The code in "units=cm/sec2(04)", "units=g.     (02)" or "units= counts(50)".
std::optional<int> unit_code_in(std::string_view text) {
  const auto units = text.find("UNIT");
  const auto open = units == kNone ? kNone : text.find('(', units);
  if (open == kNone) return {};
  const auto code = number(text.substr(open + 1, text.find(')', open) - open - 1));
  return code && *code >= 0 && *code < 1000 ? std::optional(static_cast<int>(*code)) : std::nullopt;
}

/// Whether a line is the first of a COSMOS channel: "... (Format v01.20 with 13 text lines) ...".
bool starts_cosmos_channel(std::string_view line) {
  const std::string text = upper(line.substr(0, 200));
  return text.find("(FORMAT V") != kNone && text.find("TEXT LINES)") != kNone;
}

constexpr double kMillisecond = 1e-3;
constexpr double kMicrovolt = 1e-6;
constexpr double kPeakRounding = 5e-4;  ///< of the peak: three digits and more are printed
constexpr double kSameStep = 1e-6;      ///< share by which two statements of a time step may differ
constexpr double kSameFactor = 0.01;    ///< the like of the value of a count

/// Quantity of a series: its own line says it, or else the header; "acceleration" if a record.
std::string quantity_of(const Channel& channel, const Series& series) {
  const int code = static_cast<int>(channel.integer(2).value_or(0));
  const char* stated = meaning(kQuantities, code);
  if (stated && code != 1) return stated;
  if (series.text.find("VEL") != kNone) return "velocity";
  if (series.text.find("DIS") != kNone) return "displacement";
  if (series.text.find("ACC") != kNone || stated) return "acceleration";
  return "something its header does not name";
}

class CosmosReader : LayoutReader {
 public:
  using LayoutReader::LayoutReader;

  std::vector<Component> read() {
    std::vector<Channel> channels;
    for (skip_ends(); !at_end() && !errors.any(); skip_ends()) {
      channels.emplace_back();
      read_channel(channels.back());
    }
    errors.throw_if_any();
    std::vector<Component> components;
    std::string others;
    for (const Channel& channel : channels)
      for (const Series& series : channel.series) {
        const std::string quantity = quantity_of(channel, series);
        if (quantity == "acceleration")
          components.push_back(component(channel, series));
        else if (others.find(quantity) == kNone)
          others += (others.empty() ? "" : ", ") + quantity;
      }
    if (components.empty())
      error(1, fmt::format("a record must be acceleration, but this file holds {}; take the "
                           "acceleration file of this record (.V1c, .acc.V2c)",
                           others));
    for (Component& each : components)
      if (!others.empty()) each.header.emplace_back("also in the file", others);
    return checked(components);
  }

 private:
  bool at_end() const { return next_ >= file.lines().size(); }
  std::string text() const { return at_end() ? "" : upper(file.lines()[next_].substr(0, 200)); }

  void skip_ends() {
    while (!at_end()) {
      const std::string line = text();
      const bool is_end = line.starts_with("END-OF-DATA") || line.starts_with("/&") ||
                          line.find("END OF DATA") != kNone;
      if (!is_end && !trimmed(line).empty()) return;
      ++next_;
    }
  }

  void refuse_line(const std::string& what) {
    const std::string found = at_end() ? "the end of the file" : "'" + text().substr(0, 60) + "'";
    error(std::min(next_ + 1, file.lines().size()), what + ", got " + found);
  }

  void read_channel(Channel& channel) {
    channel.first_line = next_;
    const std::string first = text();
    const auto lines = number_after(first, " WITH");
    if (!starts_cosmos_channel(first) || !lines || !(*lines >= 1 && *lines <= 100))
      return refuse_line("a channel must begin with a line '(Format vNN.NN with NN text lines)'");
    for (double i = 0; i < *lines && !at_end(); ++i, ++next_) channel.text.push_back(text());
    read_unknowns(channel);
    read_numbers("INTEGER", channel.integers);
    read_numbers("REAL", channel.reals);
    read_comments(channel);
    if (!errors.any()) read_all_series(channel);
  }

  /// The last line of text ends with "-999, -999.0", the values for what is not known.
  static void read_unknowns(Channel& channel) {
    if (channel.text.empty()) return;
    const std::string& line = channel.text.back();
    auto rest = trimmed(std::string_view(line).substr(line.rfind(':') + 1));
    const auto integer = take_number(rest);
    if (!integer) return;
    rest = trimmed(rest.starts_with(',') ? rest.substr(1) : rest);
    channel.unknown_integer = *integer;
    channel.unknown_real = take_number(rest).value_or(channel.unknown_real);
  }

  static std::optional<std::size_t> count_of(std::string_view line) {
    constexpr double kMaxNumbers = 1e8;
    line = trimmed(line);
    const auto count = take_number(line);
    if (!count || !(*count >= 0 && *count <= kMaxNumbers && *count == std::floor(*count)))
      return {};
    return static_cast<std::size_t>(*count);
  }

  void read_numbers(const std::string& kind, std::vector<double>& numbers) {
    if (errors.any()) return;
    const std::string line = text();
    const auto count = count_of(line);
    const auto format = format_in(line);
    if (!count || !format || line.find(kind) == kNone)
      return refuse_line(
          fmt::format("expected 'NNN {}-header values follow on NN lines, Format=(...)'",
                      kind == "REAL" ? "Real" : "Integer"));
    ++next_;
    numbers = fields.read(next_, *count, *format, EmptyField::kZero, "numbers of the header");
  }

  void read_comments(Channel& channel) {
    const std::string line = text();
    if (errors.any() || line.find("COMMENT") == kNone) return;
    const auto count = count_of(line);
    if (!count) return refuse_line("expected 'NN Comment line(s) follow'");
    const std::size_t end = std::min(next_ + 1 + *count, file.lines().size());
    for (++next_; next_ < end; ++next_) {
      const std::string comment = text();
      const auto at = comment.find("<SCNL>");
      if (at == kNone) continue;
      const auto parts = words_of(std::string_view(comment).substr(at + 6), ". \t");
      if (parts.size() > 1) channel.code = parts[1];
    }
  }

  static bool is_announcement(const std::string& line) {
    return count_of(line) && (line.find("UNIT") != kNone || line.find("PTS") != kNone) &&
           format_in(line);
  }

  void read_all_series(Channel& channel) {
    if (!is_announcement(text()))
      return refuse_line(
          "expected 'NNNN acceleration pts, approx NN secs, units=...(NN),Format=(...)'");
    while (!errors.any() && is_announcement(text())) {
      Series series{.line = next_, .text = text(), .unit_code = {}, .values = {}};
      series.unit_code = unit_code_in(series.text);
      ++next_;
      series.values = fields.read(next_, *count_of(series.text), *format_in(series.text),
                                  EmptyField::kError, "samples");
      if (!errors.any()) check_enough(static_cast<double>(series.values.size()), series.line + 1);
      channel.series.push_back(std::move(series));
    }
  }

  Component component(const Channel& channel, const Series& series) {
    line_ = series.line + 1;
    Component component;
    const double to_si = si_of(channel, series, component);
    component.time_step = time_step_of(channel, component);
    component.acceleration = scaled(series.values, to_si);
    check_holes(channel, series);
    if (errors.any()) return component;
    check_length(channel.real(63).value_or(0), line_, component);
    if (const auto peak = channel.real(64); peak && *peak != 0) {
      const double size = std::abs(*peak) * to_si;
      check_peak({size, kPeakRounding * size, line_}, component.acceleration, component);
    }
    orient(channel, component);
    state_facts(channel, component);
    return component;
  }

  double si_of(const Channel& channel, const Series& series, Component& component) {
    const auto in_header = channel.integer(3);
    const int code = series.unit_code.value_or(static_cast<int>(in_header.value_or(0)));
    if (in_header && *in_header != code)
      state_other_unit(static_cast<int>(*in_header), code, component);
    if (code == kCounts) return si_per_count(channel, component);
    if (options.si_per_count)
      error(line_,
            fmt::format("count_m_per_s2 was given, but the samples are not counts (unit code "
                        "{})",
                        code));
    auto unit = unit_of_code(code);
    if (!unit && code > 0)
      error(line_, fmt::format("unit code {} is no unit of acceleration (2 is g, 4 cm/s2, 7 in/s2, "
                               "10 gal, 11 mg, 12 micro g, 50 counts)",
                               code));
    else
      unit = agreed_unit(unit, line_);
    component.unit = unit ? unit->name : "";
    return unit ? unit->to_si : 0;
  }

  /// Another unit of acceleration would be another motion; what is none cannot be meant.
  void state_other_unit(int in_header, int code, Component& component) {
    const std::string text = fmt::format(
        "the line of the samples states the unit code {}, but integer 3 of the header {}", code,
        in_header);
    if (unit_of_code(in_header) || in_header == kCounts)
      error(line_, text);
    else
      component.warnings.push_back(text + ", which is no unit of acceleration");
  }

  /// A count is (real 22, microvolts) / (real 42, volts per g) / (real 47, gain) g.
  double si_per_count(const Channel& channel, Component& component) {
    component.unit = "counts";
    if (!options.unit.empty())
      error(line_, fmt::format("unit = \"{}\" was given, but the samples are raw counts (unit code "
                               "{})",
                               options.unit, kCounts));
    const auto volts = channel.real(22), sensitivity = channel.real(42);
    const double gain = channel.real(47).value_or(1);
    double stated = 0;
    if (volts && sensitivity && *volts > 0 && *sensitivity > 0 && gain > 0)
      stated = *volts * kMicrovolt / (*sensitivity * gain) * kStandardGravity;
    if (const auto given = options.si_per_count) {
      if (stated > 0 && std::abs(*given - stated) > kSameFactor * stated)
        component.warnings.push_back(fmt::format(
            "count_m_per_s2 = {:.6g} was taken, but the header states {:.6g} m/s2 for a count",
            *given, stated));
      return *given;
    }
    if (!(stated > 0)) {
      error(line_,
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

  double time_step_of(const Channel& channel, Component& component) {
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
    return agreed_time_step(step, line_);
  }

  /// Samples that are the value for "unknown" are holes, unless the motion passes through it.
  void check_holes(const Channel& channel, const Series& series) {
    const double hole = channel.unknown_real;
    const auto& values = series.values;
    const auto is_far = [&](double value) { return std::abs(value - hole) > 0.5 * std::abs(hole); };
    for (std::size_t i = 0; i < values.size(); ++i)
      if (values[i] == hole &&
          ((i > 0 && is_far(values[i - 1])) || (i + 1 < values.size() && is_far(values[i + 1]))))
        return error(line_, fmt::format("sample {} of {} is {}, which stands for an unknown value",
                                        i + 1, values.size(), hole));
  }

  /// "Sta Chan  1: 360 deg (Rcrdr Chan  1) Location: ..."
  std::string label_of(const Channel& channel) const {
    for (std::size_t i = 0; i < channel.text.size(); ++i) {
      if (!channel.text[i].starts_with("STA CHA")) continue;
      auto line = file.lines()[channel.first_line + i];
      line = line.substr(0, std::min(line.find('('), channel.text[i].find("LOCATION")));
      return std::string(trimmed(line.substr(line.rfind(':') + 1)));
    }
    return {};
  }

  /// "Location: ..." of the line of the channel and the recorder's serial number.
  void state_place(const Channel& channel, Component& component) const {
    constexpr std::string_view kLocation = "LOCATION:";
    for (std::size_t i = 0; i < channel.text.size(); ++i) {
      const auto at = channel.text[i].find(kLocation);
      if (!channel.text[i].starts_with("STA CHA") || at == kNone) continue;
      const auto place =
          trimmed(file.lines()[channel.first_line + i].substr(at + kLocation.size()));
      if (!place.empty()) component.header.emplace_back("location", place);
    }
    const auto serial =
        channel.text.size() > 6 ? number_after(channel.text[6], "S/N") : std::optional<double>();
    if (serial) component.header.emplace_back("recorder", fmt::format("s/n {:.0f}", *serial));
  }

  void orient_by_text(const Channel& channel, Component& component) const {
    if (!orient_by_label(component.name, component)) orient_by_label(channel.code, component);
  }

  void orient(const Channel& channel, Component& component) {
    component.name = label_of(channel);
    if (component.name.empty()) component.name = channel.code;
    const auto north = channel.integer(54), reference = channel.integer(55);
    const int code = static_cast<int>(north.value_or(reference.value_or(0)));
    if (code == kUp || code == kVertical) {
      component.direction = Direction::kVertical;
    } else if (code == kDown) {
      turn_up("code 401", component);
    } else if (const char* other = meaning(kOrientations, code)) {
      component.header.emplace_back("orientation", other);
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

  void state_facts(const Channel& channel, Component& component) const {
    const auto state = [&](const char* name, std::size_t index) {
      if (index < channel.text.size())
        component.header.emplace_back(name, trimmed(file.lines()[channel.first_line + index]));
    };
    state("stage", 0);
    state("event", 1);
    state("station", 4);
    state("peak", 10);
    state("filter", 11);
    state_place(channel, component);
    if (const char* structure =
            meaning(kStructures, static_cast<int>(channel.integer(19).value_or(0))))
      component.header.emplace_back("structure", structure);
    const auto part = [&](std::size_t number) {
      return static_cast<int>(channel.integer(number).value_or(-1));
    };
    if (const auto second = channel.real(30); second && part(42) > 0 && part(43) > 0)
      component.start_time = utc_seconds(part(40), part(42), part(43), part(44), part(45), *second);
  }

  std::size_t next_ = 0;  ///< line to be read, from 0
  std::size_t line_ = 1;  ///< of the series, from 1
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
  if (holds_spectra(file)) refuse_spectra(file.name(), "V3", "the V2");
  return CosmosReader(file, options).read();
}

}  // namespace gurney::groundmotions
