// Volumes in the layout that the California Institute of Technology began: lines of text, numbers in
// fixed columns, samples in fixed columns, channel after channel.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "groundmotions/formats/calendar.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/time_column.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {
namespace {

constexpr double kMaxSamples = 1e7;

bool is_count(double value) {
  return value >= 2 && value <= kMaxSamples && value == std::floor(value);
}

/// A series of samples and the line that announces it: "12001 POINTS OF ACCEL DATA EQUALLY SPACED
/// AT .005 SEC. (UNITS: G)". Without such a line the numbers are pairs of a time and a value.
struct Series {
  std::size_t line = 0;  ///< index from 0 of the announcement, else of the first numbers
  bool is_acceleration = true;
  std::optional<double> time_step;       ///< as announced [s]
  std::optional<AccelerationUnit> unit;  ///< as announced
  std::vector<double> times;             ///< of pairs [s], else empty
  std::vector<double> values;
};

/// One channel: lines of text, 100 integers in 16I5, 50 real numbers (volume 1) or 100 (volume 2)
/// in 8F10.3, then series.
struct Channel {
  std::size_t first_line = 0;     ///< index from 0
  std::vector<std::string> text;  ///< header lines, in capitals
  std::vector<double> integers;   ///< 100; NaN where a number did not fit its field
  std::vector<double> reals;      ///< 50 or 100
  std::vector<Series> series;
  std::string trailing;  ///< a last line of the file that is neither samples nor a header

  bool corrected() const { return reals.size() > 50; }  ///< volume 2

  /// Index in `text` of the first line that has `key`.
  std::optional<std::size_t> find(std::string_view key) const {
    const auto has_key = [&](const std::string& line) { return line.find(key) != kNone; };
    const auto at = std::ranges::find_if(text, has_key);
    return at == text.end() ? std::nullopt
                            : std::optional(static_cast<std::size_t>(at - text.begin()));
  }
  /// In the file, from 1; the first line where the text has none.
  std::size_t line_of(std::optional<std::size_t> index) const {
    return first_line + index.value_or(0) + 1;
  }
};

/// What all readers of volumes do: they go through the file line by line.
struct VolumeReader : LayoutReader {
  using LayoutReader::LayoutReader;

  std::size_t next = 0;  ///< line, from 0

  std::string_view line(std::size_t index) const { return file.lines()[index]; }
  bool at_end() const { return next >= file.lines().size(); }
  void skip_blanks() {
    while (!at_end() && is_blank(line(next))) ++next;
  }
  void report_end_of_samples() {
    error(next + 1,
          fmt::format("the samples of this channel end here, but neither the next channel "
                      "nor the end of the file follows: '{}'",
                      trimmed(line(next)).substr(0, 60)));
  }
};

class CaltechReader : VolumeReader {
 public:
  using VolumeReader::VolumeReader;

  /// The acceleration of every channel of a volume 1 or 2, with what its header states checked:
  /// count, unit, time step, length, peak and azimuth. Pairs of time and value at uneven times are
  /// brought to an even step.
  /// @throws Error with all errors of the file.
  std::vector<Component> read() {
    std::vector<Channel> channels;
    for (skip_blanks(); !at_end() && !errors.any(); skip_blanks())
      channels.push_back(read_channel());
    errors.throw_if_any();
    std::vector<Component> components;
    for (const Channel& channel : channels) components.push_back(component(channel));
    return checked(components);
  }

 private:
  Channel read_channel() {
    Channel channel;
    channel.first_line = next;
    read_header(channel);
    if (errors.any()) return channel;
    skip_blanks();
    do channel.series.push_back(read_series(channel));
    while (!errors.any() && next_is_series());
    if (!at_end() && is_end_mark(line(next))) ++next;
    skip_blanks();
    if (errors.any() || at_end() || upper(line(next)).find("ACCELEROGRAM") != kNone) return channel;
    const std::size_t behind = next;
    const auto text = trimmed(line(next++));
    skip_blanks();
    if (at_end() && is_letter(text[0])) {
      channel.trailing = text;
      return channel;
    }
    next = behind;
    report_end_of_samples();
    return channel;
  }

  /// The text ends where the first line of whole integers begins: its number of lines varies.
  void read_header(Channel& channel) {
    constexpr std::size_t kMaxTextLines = 40;  // 13 in volume 1, 25 in volume 2
    const FortranFormat wide = *fortran_format("16I5"), narrow = *fortran_format("20I4");
    const std::size_t end = std::min(file.lines().size(), next + kMaxTextLines);
    while (next < end && !fields.fits(next, 16, wide) && !fields.fits(next, 20, narrow))
      channel.text.push_back(upper(line(next++)));
    if (next == end)
      return error(channel.first_line + 1,
                   fmt::format("no integer header (16I5) within {} lines of this channel's header",
                               kMaxTextLines));
    const auto& format = fields.fits(next, 16, wide) ? wide : narrow;
    channel.integers = fields.read(next, 100, format, EmptyField::kZero, "integers of the header");
    const bool corrected =
        !channel.text.empty() && trimmed(channel.text[0]).starts_with("CORRECTED");
    channel.reals = fields.read(next, corrected ? 100 : 50, *fortran_format("8F10.3"),
                                EmptyField::kZero, "real numbers of the header");
  }

  bool next_is_series() {
    skip_blanks();
    return !at_end() && is_announcement(upper(line(next)));
  }

  static bool is_end_mark(std::string_view text) {
    return text.starts_with("/&") || upper(text).find("END OF DATA") != kNone;
  }

  static bool is_announcement(const std::string& text) {
    std::string_view rest = trimmed(text);
    return take_number(rest) && rest.find("POINTS") != kNone;
  }

  Series read_series(const Channel& channel) {
    Series series;
    series.line = next;
    if (at_end()) {
      error(file.lines().size(), "the file ends behind the header: no samples");
      return series;
    }
    const std::string text = upper(line(next));
    if (is_announcement(text))
      read_announced(text, series);
    else
      read_pairs(channel, series);
    return series;
  }

  std::size_t checked_count(double count, std::size_t index) {
    if (is_count(count)) return static_cast<std::size_t>(count);
    error(index + 1,
          fmt::format("the number of samples must be a whole number above 1, got {}", count));
    return 0;
  }

  void read_announced(const std::string& text, Series& series) {
    std::string_view rest = trimmed(text);
    const std::size_t count = checked_count(*take_number(rest), next);
    series.is_acceleration = rest.find("ACC") != kNone;
    series.time_step = step_in(rest);
    series.unit = unit_in(rest);
    ++next;
    if (at_end()) return error(file.lines().size(), "the file ends behind this line");
    if (count == 0) return;
    constexpr std::array kFormats = {"8F10.3", "8F9.6", "10F8.3", "10F7.3"};
    const auto format = announced_format(rest);
    series.values = fields.read(next, count, format ? *format : fitting(kFormats, count),
                                EmptyField::kError, "samples");
  }

  static std::optional<FortranFormat> announced_format(std::string_view text) {
    const auto open = text.rfind('(');
    if (open == kNone) return {};
    return fortran_format(text.substr(open, text.find(')', open) - open + 1));
  }

  /// "EQUALLY SPACED AT .005 SEC" or "AT 200 PTS/SEC".
  static std::optional<double> step_in(std::string_view text) {
    const auto at = text.find(" AT ");
    if (at == kNone) return {};
    std::string_view rest = trimmed(text.substr(at + 4));
    const auto value = take_number(rest);
    const auto unit = trimmed(rest).substr(0, trimmed(rest).find(' '));
    return value && unit.find("/S") != kNone ? 1 / *value : value;
  }

  /// The first format that fits the next line, or else (that line has an error) the first of its
  /// length.
  template <std::size_t N>
  FortranFormat fitting(const std::array<const char*, N>& candidates, std::size_t count) const {
    for (const char* candidate : candidates) {
      const FortranFormat format = *fortran_format(candidate);
      if (fields.fits(next, std::min(count, format.per_line), format)) return format;
    }
    const std::size_t length = line(next).find_last_not_of(' ') + 1;
    for (const char* candidate : candidates) {
      const FortranFormat format = *fortran_format(candidate);
      if (length == format.skip + format.per_line * format.width) return format;
    }
    return *fortran_format(candidates[0]);
  }

  /// The text states the number of pairs; integer 28 does too, but has room for five digits only.
  void read_pairs(const Channel& channel, Series& series) {
    constexpr std::array kFormats = {"10F7.3", "1X,10F7.3", "8F7.3", "1X,8F7.3", "8F10.3"};
    const auto at = channel.find("NO. OF POINTS");
    const auto count = at ? number_after(channel.text[*at], "NO. OF POINTS") : std::nullopt;
    const std::size_t pairs =
        checked_count(count.value_or(channel.integers[27]), channel.first_line + at.value_or(0));
    if (pairs == 0) return;
    const auto numbers = fields.read(next, 2 * pairs, fitting(kFormats, 2 * pairs),
                                     EmptyField::kError, "numbers (a time and a value each)");
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
      series.times.push_back(numbers[i]);
      series.values.push_back(numbers[i + 1]);
    }
  }

  Component component(const Channel& channel) {
    Component component;
    const auto series = std::ranges::find_if(channel.series, &Series::is_acceleration);
    if (series == channel.series.end()) {
      error(channel.first_line + 1,
            "this channel holds velocity or displacement only; a record must be acceleration");
      return component;
    }
    const AccelerationUnit unit = unit_of(channel, *series, component);
    component.unit = unit.name;
    take_samples(channel, *series, component);
    if (errors.any()) return component;
    component.acceleration *= unit.to_si;
    check_length(channel.reals[channel.corrected() ? 59 : 2], channel.first_line + 1, component);
    const double step = channel.corrected() ? channel.reals[60] : 0;
    if (step > 0 && std::abs(step - component.time_step) > 1e-3 * step)
      component.warnings.push_back(
          fmt::format("real number 61 of the header states a time step of {} s, but the line above "
                      "the samples {} s, which was taken",
                      step, component.time_step));
    check_stated_peak(channel, *series, unit.to_si, component);
    if (!channel.trailing.empty())
      component.warnings.push_back(
          fmt::format("the last line of the file is no part of the format and was ignored: '{}'",
                      channel.trailing.substr(0, 60)));
    orient(channel, component);
    state_facts(channel, component);
    return component;
  }

  AccelerationUnit unit_of(const Channel& channel, const Series& series, Component& component) {
    if (series.unit) return agreed_unit(series.unit, series.line + 1);
    const auto at = channel.find(channel.corrected() ? "PEAK ACCELERATION" : "UNITS");
    const auto stated = at ? unit_in(channel.text[*at]) : std::nullopt;
    const double fraction = channel.reals[4];  // of g, in volume 1; some files state 1 for g/10
    if (stated && !channel.corrected() && fraction > 0 &&
        std::abs(fraction * kStandardGravity - stated->to_si) > 1e-3 * stated->to_si)
      component.warnings.push_back(
          fmt::format("the text states the unit {}, which was taken, but real number 5 of the "
                      "header {} g",
                      stated->name, fraction));
    return agreed_unit(stated, channel.line_of(at));
  }

  void take_samples(const Channel& channel, const Series& series, Component& component) {
    constexpr double kGrid = 1e-6;  // printed times on an even grid differ by less [s]
    const auto& times = series.times;
    component.acceleration = scaled(series.values, 1);
    if (times.empty()) {
      auto step = series.time_step;
      if (!step && channel.corrected() && channel.reals[60] > 0) step = channel.reals[60];
      component.time_step = agreed_time_step(step, series.line + 1);
    } else if (times.size() >= 2 && spacing_of(times).even(kGrid)) {
      const double mean = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
      component.time_step = agreed_time_step(std::round(mean / kGrid) * kGrid, series.line + 1);
    } else if (times.size() >= 2) {
      component.time_step = options.time_step.value_or(kEvenTimeStep);
      try {
        component.acceleration = evenly_spaced(times, series.values, component.time_step);
        component.warnings.push_back(uneven_warning(times, component.time_step));
      } catch (const Error& uneven) {
        error(series.line + 1, uneven.what());
      }
    }
  }

  void check_stated_peak(const Channel& channel, const Series& series, double to_si,
                         Component& component) {
    constexpr double kPeakOfVolume1 = 0.00056;  // printed to 0.001 g, the samples to 0.0001 g [g]
    constexpr double kPeakOfVolume2 = 1.1e-5;   // both are printed to 0.001 cm/s2 [m/s2]
    constexpr double kPeakTooFar = 0.1;         // of the peak; an assumption
    constexpr double kPeakShare = 1e-4;         // of large peaks with fewer digits after the point
    const bool corrected = channel.corrected();
    const auto at = channel.find(corrected ? "PEAK ACCELERATION" : "UNITS OF UNCOR");
    const auto peak = at ? number_after(channel.text[*at], corrected ? "PEAK ACCELERATION" : "MAX")
                         : std::nullopt;
    if (!peak) return;
    const double size = std::abs(*peak) * (corrected ? 0.01 : kStandardGravity);
    const double rounding = corrected ? kPeakOfVolume2 : kPeakOfVolume1 * kStandardGravity;
    const Eigen::VectorXd samples = scaled(series.values, to_si);
    check_peak({size, std::max(rounding, kPeakShare * size), channel.line_of(at)}, samples,
               component);
    const double raw = samples.cwiseAbs().maxCoeff();
    const double centred = (samples.array() - samples.mean()).abs().maxCoeff();
    const double difference = std::min(std::abs(raw - size), std::abs(centred - size));
    if (difference > kPeakTooFar * size + rounding && !errors.any())
      error(channel.line_of(at),
            fmt::format("the header states a peak of {:.5g} m/s2, but the samples have {:.5g} "
                        "m/s2: one of them is damaged",
                        size, raw));
  }

  /// "CHAN  1:  90 DEG  (STA CHN: 14)", "Chan  1: Up   Location: Roof" of CSMIP, "COMP N08W" of
  /// USC.
  std::string label_of(const Channel& channel) const {
    for (std::size_t i = 0; i < channel.text.size(); ++i) {
      const auto text = trimmed(line(channel.first_line + i));
      const std::string capitals = upper(text);
      if (capitals.starts_with("CHAN") && text.find(':') != kNone) {
        const auto begin = text.find(':') + 1;
        const auto end = std::min(text.find('(', begin), capitals.find("LOCATION", begin));
        return std::string(trimmed(text.substr(begin, end - begin)));
      }
      if (capitals.starts_with("COMP ")) {
        const auto label = trimmed(text.substr(5));
        return std::string(label.substr(0, label.find("  ")));
      }
    }
    return {};
  }

  /// Integer 27 is the azimuth, 500 for up or 600 for down; 0 also where it is not known.
  void orient(const Channel& channel, Component& component) {
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

  void state_facts(const Channel& channel, Component& component) const {
    const bool corrected = channel.corrected();
    const auto state = [&](const char* name, std::optional<std::size_t> index) {
      if (!index || *index >= channel.text.size()) return;
      const auto text = trimmed(line(channel.first_line + *index));
      if (!text.empty()) component.header.emplace_back(name, text);
    };
    component.header.emplace_back("volume", corrected ? "2 (corrected)" : "1 (uncorrected)");
    state("event", corrected ? 2 : 1);
    state("station", corrected ? 6 : 5);
    state("station line", corrected ? 5 : 4);
    state("filter", channel.find("FILTERED"));
    state("peak", channel.find("UNITS OF UNCOR"));
    state("peak", channel.find("PEAK ACCEL"));
    state("trigger", channel.find("TRIGGER TIME"));
    state_place(channel, component);
    if (channel.series.size() > 1)
      component.header.emplace_back("also in the file", "velocity, displacement");
    if (const auto at = channel.find("START TIME"))
      component.start_time = time_in(channel.text[*at]);
  }

  /// "Chan  4: 90 Deg  Location: Roof - N wall" and the recorder of "SMA-1 S/N 5254".
  void state_place(const Channel& channel, Component& component) const {
    constexpr std::string_view kLocation = "LOCATION:";
    if (const auto at = channel.find(kLocation)) {
      const auto place = line(channel.first_line + *at)
                             .substr(channel.text[*at].find(kLocation) + kLocation.size());
      if (!is_blank(place)) component.header.emplace_back("location", trimmed(place));
    }
    const std::size_t index = channel.corrected() ? 5 : 4;
    if (index >= channel.text.size()) return;
    if (const auto serial = number_after(channel.text[index], "S/N"))
      component.header.emplace_back("recorder", fmt::format("s/n {:.0f}", *serial));
  }

  /// "START TIME:  8/29/18, 02:33:  .0 UTC": month, day, year.
  static std::optional<double> time_in(std::string_view text) {
    constexpr std::string_view kKey = "START TIME";
    text.remove_prefix(text.find(kKey));
    const bool daylight = text.find("PDT") != kNone, pacific = text.find("PST") != kNone;
    const double hours_to_utc = pacific ? 8 : daylight ? 7 : 0;
    if (hours_to_utc == 0 && text.find("UTC") == kNone && text.find("GMT") == kNone) return {};
    std::string numbers(text.substr(kKey.size()));
    std::ranges::replace_if(
        numbers, [](char c) { return c == '/' || c == ':' || c == ','; }, ' ');
    double parts[6];
    std::string_view rest = numbers;
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
    return time ? std::optional(*time + 3600 * hours_to_utc) : std::nullopt;
  }
};

std::string first_text(const SourceFile& file) {
  const auto line = std::ranges::find_if_not(file.lines(), is_blank);
  return line == file.lines().end() ? "" : upper(trimmed(*line).substr(0, 200));
}

// --- BHRC, Iran: volume 1 with one line of a time step, without pairs

bool starts_bhrc_channel(std::string_view line) {
  return upper(line.substr(0, 20)).starts_with("* VOL");
}

class BhrcReader : VolumeReader {
 public:
  using VolumeReader::VolumeReader;

  std::vector<Component> read() {
    std::vector<Component> components;
    while (!at_end() && !errors.any()) {
      const auto text = trimmed(line(next));
      if (starts_bhrc_channel(text))
        components.push_back(component());
      else if (text.empty() || text.starts_with("/&"))
        ++next;
      else
        report_end_of_samples();
    }
    return checked(components);
  }

 private:
  Component component() {
    constexpr std::size_t kMaxHeaderLines = 40;  // 27 in the files of this volume
    Channel channel;
    channel.first_line = next;
    if (upper(line(next)).find("VOL1") == kNone) {
      error(next + 1, "only volume 1 (VOL1DS) of BHRC is read");
      return {};
    }
    const FortranFormat format = *fortran_format("10E13.6");
    const std::size_t end = std::min(file.lines().size(), next + kMaxHeaderLines);
    while (next < end && !fields.fits(next, 10, format))
      channel.text.push_back(upper(line(next++)));
    const auto points = channel.find("NO. OF POINTS"), unit_line = channel.find("UNITS ARE");
    const auto count = points ? number_after(channel.text[*points], "NO. OF POINTS") : std::nullopt;
    if (next == end || !count || !is_count(*count)) {
      error(channel.first_line + 1,
            "this channel has no header with NO. OF POINTS = (a whole number above 1) and "
            "samples in 10E13.6 within 40 lines");
      return {};
    }
    const auto unit = agreed_unit(unit_line ? unit_in(channel.text[*unit_line]) : std::nullopt,
                                  channel.line_of(unit_line));
    const auto values =
        fields.read(next, static_cast<std::size_t>(*count), format, EmptyField::kError, "samples");
    std::vector<std::string> warnings;
    const double step = time_step(channel, *points, *count, warnings);
    if (errors.any()) return {};
    Component component = component_of(values, unit, step);
    component.warnings = warnings;
    describe(channel, component);
    return component;
  }

  /// The duration is that of all samples. Real number 9 is the rate: the first of the second line
  /// with exponents.
  double time_step(const Channel& channel, std::size_t points, double count,
                   std::vector<std::string>& warnings) {
    constexpr double kRateTolerance = 0.01;  // the duration may count steps or samples
    const auto& text = channel.text;
    const auto duration = number_after(text[points], "DURATION");
    std::optional<double> step;
    if (duration && *duration > 0) step = *duration / count;
    std::size_t exponents = 0;
    for (std::size_t i = points; i < text.size(); ++i) {
      if (text[i].find("E+0") == kNone || ++exponents != 2) continue;
      std::string_view rest = trimmed(text[i]);
      const auto rate = take_number(rest);
      if (!rate || !(*rate > 0)) continue;
      if (step && std::abs(1 / *rate - *step) > kRateTolerance * *step)
        warnings.push_back(fmt::format(
            "the header states {} samples per second, but also {} samples in {} s, which was taken",
            *rate, count, *duration));
      else
        step = 1 / *rate;
    }
    return agreed_time_step(step, channel.line_of(points));
  }

  /// "COMP L1" names the component, "Azimuth L 50    T 140" its direction.
  void describe(const Channel& channel, Component& component) const {
    if (const auto at = channel.find("COMP "))
      component.name = trimmed(std::string_view(channel.text[*at]).substr(5));
    if (component.name.starts_with("V")) {
      component.direction = Direction::kVertical;
    } else if (const auto at = channel.find("AZIMUTH"); at && !component.name.empty()) {
      const std::string_view text = channel.text[*at];
      const auto degrees = number_after(text.substr(text.find("AZIMUTH") + 7),
                                        fmt::format(" {} ", component.name[0]));
      if (degrees && *degrees >= 0 && *degrees <= 360)
        component.azimuth = std::fmod(*degrees, 360) * kRadiansPerDegree;
    }
    component.header.emplace_back("volume", "1 (uncorrected)");
    for (const auto& [name, key] :
         {std::pair{"event", "EPICENTER"}, std::pair{"station", "STATION"},
          std::pair{"origin time", "ORIGIN TIME"}})
      if (const auto at = channel.find(key))
        component.header.emplace_back(name, trimmed(line(channel.first_line + *at)));
  }
};

// --- blocks of USC

constexpr std::size_t kBlockLines = 7;

struct Block {
  std::string text[kBlockLines];
  std::string type;  ///< "AC", "VL", "DP"
  std::optional<double> rate, count, azimuth;
};

Block block_at(const SourceFile& file, std::size_t line) {
  Block block;
  for (std::size_t i = 0; i < kBlockLines && line + i < file.lines().size(); ++i) {
    const std::string text = block.text[i] = upper(file.lines()[line + i].substr(0, 200));
    if (const auto at = text.find("DATA TYPE="); at != kNone)
      block.type = trimmed(text.substr(at + 10));
    if (const auto rate = number_after(text, "SAMPLES/SEC")) block.rate = rate;
    if (const auto count = number_after(text, "NO OF POINTS")) block.count = count;
    if (const auto azimuth = number_after(text, "COMPONENT")) block.azimuth = azimuth;
  }
  return block;
}

class BlockReader : VolumeReader {
 public:
  using VolumeReader::VolumeReader;

  std::vector<Component> read() {
    std::vector<Component> components;
    for (skip_blanks(); !at_end() && !errors.any(); skip_blanks()) read_block(components);
    if (!errors.any() && components.empty())
      error(1,
            "this file holds velocity (VL) or displacement (DP) only; a record must be "
            "acceleration (DATA TYPE=AC)");
    return checked(components);
  }

 private:
  void read_block(std::vector<Component>& components) {
    const Block block = block_at(file, next);
    const std::size_t first = next;
    if (block.type.empty() || !block.rate || !block.count || !(*block.rate > 0) ||
        !is_count(*block.count))
      return error(first + 1,
                   "no header of a block here: 7 lines with SAMPLES/SEC= above 0, DATA TYPE= and "
                   "NO OF POINTS= above 1");
    next += kBlockLines;
    const auto values = fields.read(next, static_cast<std::size_t>(*block.count),
                                    *fortran_format("10F8.2"), EmptyField::kError, "samples");
    if (block.type != "AC") {
      if (!components.empty())
        components.back().header.emplace_back("also in the file", "data type " + block.type);
      return;
    }
    const auto unit = agreed_unit(unit_in(block.text[kBlockLines - 1]), first + kBlockLines);
    Component component = component_of(values, unit, agreed_time_step(1 / *block.rate, first + 6));
    component.name = trimmed(line(first + 1));
    component.header = {{"station", std::string(trimmed(line(first)))},
                        {"event", std::string(trimmed(line(first + 2)))},
                        {"filter", std::string(trimmed(line(first + 3)))}};
    const bool labelled = orient_by_label(component.name, component);
    if (!labelled && block.azimuth && *block.azimuth >= 0 && *block.azimuth <= 360)
      component.azimuth = std::fmod(*block.azimuth, 360) * kRadiansPerDegree;
    components.push_back(component);
  }
};

}  // namespace

bool recognises_csmip(const SourceFile& file) {
  const std::string line = first_text(file);
  return line.starts_with("UNCORRECTED ACCELEROGRAM DATA") ||
         line.starts_with("CORRECTED ACCELEROGRAM") ||
         line.starts_with("RESPONSE AND FOURIER AMPLITUDE SPECTRA");
}

/// @throws Error for volume 3 (response spectra) and what CaltechReader says.
std::vector<Component> read_csmip(const SourceFile& file, const ReadOptions& options) {
  if (first_text(file).starts_with("RESPONSE")) refuse_spectra(file.name(), "volume 3", "the .V2");
  return CaltechReader(file, options).read();
}

bool recognises_usc(const SourceFile& file) {
  const TextLines lines = file.lines();
  return std::ranges::any_of(lines.first(std::min<std::size_t>(3, lines.size())), [](auto line) {
    return upper(line.substr(0, 200)).find("OF UNCORRECTED ACCELEROGRAM DATA OF VOL") != kNone;
  });
}

/// @throws Error for volume 3 (response spectra) and what CaltechReader says.
std::vector<Component> read_usc(const SourceFile& file, const ReadOptions& options) {
  const std::string first = upper(file.lines()[0].substr(0, 200));
  if (first.find("RESPONSE") != kNone || first.find("SPECTR") != kNone)
    refuse_spectra(file.name(), "volume 3", "volume 2");
  return CaltechReader(file, options).read();
}

bool recognises_bhrc(const SourceFile& file) {
  const TextLines lines = file.lines();
  return starts_bhrc_channel(lines[0]) &&
         std::ranges::any_of(lines.first(std::min<std::size_t>(13, lines.size())), [](auto line) {
           return upper(line.substr(0, 20)).starts_with("COMP ");
         });
}

/// @returns L, V and T as the file has them.
/// @throws Error for other volumes, a wrong count, an unknown unit or text among the samples.
std::vector<Component> read_bhrc(const SourceFile& file, const ReadOptions& options) {
  return BhrcReader(file, options).read();
}

bool recognises_usc_blocks(const SourceFile& file) {
  const Block block = block_at(file, 0);
  return !block.type.empty() && block.rate;
}

/// @returns the acceleration of each component of the file.
/// @throws Error if a block has not the number of samples it states, or no block is acceleration.
std::vector<Component> read_usc_blocks(const SourceFile& file, const ReadOptions& options) {
  return BlockReader(file, options).read();
}

}  // namespace gurney::groundmotions
