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
#include "groundmotions/formats/format.h"
#include "groundmotions/formats/fortran_fields.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/formats/source_file.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/time_column.h"
#include "groundmotions/formats/words.h"
#include "groundmotions/record/acceleration_unit.h"

namespace gurney::groundmotions {
namespace {

/// A series of samples and the line that announces it: "12001 POINTS OF ACCEL DATA EQUALLY SPACED
/// AT .005 SEC. (UNITS: G)". Without such a line the numbers are pairs of a time and a value.
struct CaltechSeries {
  enum class Quantity { kAcceleration, kVelocity, kDisplacement };

  std::size_t line = 0;  ///< index from 0 of the announcement, else of the first numbers
  Quantity quantity = Quantity::kAcceleration;
  std::optional<double> time_step;       ///< as announced [s]
  std::optional<AccelerationUnit> unit;  ///< as announced
  std::vector<double> times;             ///< of pairs [s], else empty
  std::vector<double> values;
};

/// One channel of a strong motion volume in the layout that the California Institute of Technology
/// began and CSMIP, USC and RENADIC use: lines of text, 100 integers in 16I5, 50 real numbers
/// (volume 1) or 100 (volume 2) in 8F10.3, then series.
struct CaltechChannel {
  std::size_t first_line = 0;     ///< index from 0
  std::vector<std::string> text;  ///< header lines, in capitals
  std::vector<double> integers;   ///< 100; NaN where a number did not fit its field
  std::vector<double> reals;      ///< 50 or 100
  std::vector<CaltechSeries> series;
  std::string trailing;  ///< a last line of the file that is neither samples nor a header

  bool corrected() const { return reals.size() > 50; }  ///< volume 2

  /// Index in `text` of the first line that has `key`, from `begin` on.
  std::optional<std::size_t> find(std::string_view key, std::size_t begin = 0) const;
};

constexpr std::size_t kMaxTextLines = 40;  ///< 13 in volume 1, 25 in volume 2
constexpr double kMaxSamples = 1e7;

/// Formats of samples in the order they are tried; the first that fits the first line is taken,
/// or else (that line has an error) the first of its length.
constexpr std::array kSampleFormats = {"8F10.3", "8F9.6", "10F8.3", "10F7.3"};
constexpr std::array kPairFormats = {"10F7.3", "1X,10F7.3", "8F7.3", "1X,8F7.3", "8F10.3"};

class CaltechVolume {
 public:
  CaltechVolume(const SourceFile& file, FileErrors& errors)
      : file_(file), errors_(errors), fields_(file, errors) {}

  std::vector<CaltechChannel> read() {
    std::vector<CaltechChannel> channels;
    for (skip_blanks(); line_ < file_.lines().size() && !errors_.any(); skip_blanks())
      channels.push_back(read_channel());
    return channels;
  }

 private:
  std::string_view line(std::size_t index) const { return file_.lines()[index]; }
  bool at_end() const { return line_ >= file_.lines().size(); }
  void skip_blanks() {
    while (!at_end() && trimmed(line(line_)).empty()) ++line_;
  }

  CaltechChannel read_channel() {
    CaltechChannel channel{
        .first_line = line_, .text = {}, .integers = {}, .reals = {}, .series = {}, .trailing = {}};
    if (read_header(channel)) read_all_series(channel);
    return channel;
  }

  /// The text ends where the first line of whole integers begins: its number of lines varies.
  bool read_header(CaltechChannel& channel) {
    const FortranFormat wide = *fortran_format("16I5"), narrow = *fortran_format("20I4");
    const std::size_t end = std::min(file_.lines().size(), line_ + kMaxTextLines);
    while (line_ < end && !fields_.fits(line_, 16, wide) && !fields_.fits(line_, 20, narrow))
      channel.text.push_back(upper(line(line_++)));
    if (line_ == end) {
      errors_.add(channel.first_line + 1, 1,
                  fmt::format("no integer header (16I5) within {} lines of this channel's header",
                              kMaxTextLines));
      return false;
    }
    const auto& format = fields_.fits(line_, 16, wide) ? wide : narrow;
    channel.integers =
        fields_.read(line_, 100, format, EmptyField::kZero, "integers of the header");
    const bool corrected =
        !channel.text.empty() && trimmed(channel.text[0]).starts_with("CORRECTED");
    channel.reals = fields_.read(line_, corrected ? 100 : 50, *fortran_format("8F10.3"),
                                 EmptyField::kZero, "real numbers of the header");
    return !errors_.any();
  }

  void read_all_series(CaltechChannel& channel) {
    skip_blanks();
    do channel.series.push_back(read_series(channel));
    while (!errors_.any() && next_is_series());
    if (!at_end() && is_end_mark(line(line_))) ++line_;
    skip_blanks();
    if (errors_.any() || at_end() || upper(line(line_)).find("ACCELEROGRAM") != kNone) return;
    const std::size_t behind = line_;
    const auto text = trimmed(line(line_++));
    skip_blanks();
    if (at_end() && std::isalpha(static_cast<unsigned char>(text[0]))) {
      channel.trailing = text;
      return;
    }
    line_ = behind;
    errors_.add(line_ + 1, 1,
                fmt::format("the samples of this channel end here, but neither the next channel "
                            "nor the end of the file follows: '{}'",
                            trimmed(line(line_)).substr(0, 60)));
  }

  bool next_is_series() {
    skip_blanks();
    return !at_end() && is_announcement(upper(line(line_)));
  }

  static bool is_end_mark(std::string_view text) {
    return text.starts_with("/&") || upper(text).find("END OF DATA") != kNone;
  }

  static bool is_announcement(const std::string& text) {
    std::string_view rest = trimmed(text);
    return take_number(rest) && rest.find("POINTS") != kNone;
  }

  CaltechSeries read_series(const CaltechChannel& channel) {
    CaltechSeries series;
    series.line = line_;
    if (at_end()) {
      errors_.add(file_.lines().size(), 1, "the file ends behind the header: no samples");
      return series;
    }
    const std::string text = upper(line(line_));
    if (is_announcement(text))
      read_announced(text, series);
    else
      read_pairs(channel, series);
    return series;
  }

  std::size_t checked_count(double count, std::size_t index) {
    if (count >= 2 && count <= kMaxSamples && count == std::floor(count))
      return static_cast<std::size_t>(count);
    errors_.add(index + 1, 1,
                fmt::format("the number of samples must be a whole number above 1, got {}", count));
    return 0;
  }

  void read_announced(const std::string& text, CaltechSeries& series) {
    std::string_view rest = trimmed(text);
    const std::size_t count = checked_count(*take_number(rest), line_);
    if (rest.find("ACC") == kNone)
      series.quantity = rest.find("VEL") != kNone ? CaltechSeries::Quantity::kVelocity
                                                  : CaltechSeries::Quantity::kDisplacement;
    series.time_step = step_in(rest);
    series.unit = unit_in(rest);
    ++line_;
    if (count == 0 || at_end()) {
      if (at_end()) errors_.add(file_.lines().size(), 1, "the file ends behind this line");
      return;
    }
    const auto format = announced_format(rest);
    series.values = fields_.read(line_, count, format ? *format : fitting(kSampleFormats, count),
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

  template <std::size_t N>
  FortranFormat fitting(const std::array<const char*, N>& candidates, std::size_t count) const {
    for (const char* candidate : candidates) {
      const FortranFormat format = *fortran_format(candidate);
      if (fields_.fits(line_, std::min(count, format.per_line), format)) return format;
    }
    const auto text = line(line_).substr(0, line(line_).find_last_not_of(' ') + 1);
    for (const char* candidate : candidates) {
      const FortranFormat format = *fortran_format(candidate);
      if (text.size() == format.skip + format.per_line * format.width) return format;
    }
    return *fortran_format(candidates[0]);
  }

  /// The text states the number of pairs; integer 28 does too, but has room for five digits only.
  void read_pairs(const CaltechChannel& channel, CaltechSeries& series) {
    const auto at = channel.find("NO. OF POINTS");
    auto count = at ? number_after(channel.text[*at], "NO. OF POINTS") : std::nullopt;
    if (!count) count = channel.integers[27];
    const std::size_t pairs = checked_count(*count, channel.first_line + at.value_or(0));
    if (pairs == 0) return;
    const auto numbers = fields_.read(line_, 2 * pairs, fitting(kPairFormats, 2 * pairs),
                                      EmptyField::kError, "numbers (a time and a value each)");
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
      series.times.push_back(numbers[i]);
      series.values.push_back(numbers[i + 1]);
    }
  }

  const SourceFile& file_;
  FileErrors& errors_;
  FieldReader fields_;
  std::size_t line_ = 0;
};

std::optional<std::size_t> CaltechChannel::find(std::string_view key, std::size_t begin) const {
  for (std::size_t i = begin; i < text.size(); ++i)
    if (text[i].find(key) != std::string::npos) return i;
  return {};
}

/// All channels of a file. Counts are checked against the numbers that are there.
std::vector<CaltechChannel> caltech_channels(const SourceFile& file, FileErrors& errors) {
  return CaltechVolume(file, errors).read();
}

constexpr double kGrid = 1e-6;              ///< printed times on an even grid differ by less [s]
constexpr double kPeakOfVolume1 = 0.00056;  ///< printed to 0.001 g, the samples to 0.0001 g [g]
constexpr double kPeakOfVolume2 = 1.1e-5;   ///< both are printed to 0.001 cm/s2 [m/s2]
constexpr double kPeakTooFar = 0.1;         ///< of the peak; an assumption
constexpr double kPeakShare = 1e-4;         ///< of large peaks with fewer digits after the point

using Quantity = CaltechSeries::Quantity;

class CaltechComponents : public LayoutReader {
 public:
  using LayoutReader::LayoutReader;

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
    check_length(channel.reals[channel.corrected() ? 59 : 2], channel.first_line + 1, component);
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
    return agreed_unit(stated, line_of(channel, at));
  }

  void take_samples(const CaltechChannel& channel, const CaltechSeries& series,
                    Component& component) {
    std::vector<double> values = series.values;
    component.acceleration =
        Eigen::Map<Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
    if (series.times.empty()) {
      auto step = series.time_step;
      if (!step && channel.corrected() && channel.reals[60] > 0) step = channel.reals[60];
      component.time_step = agreed_time_step(step, series.line + 1);
      return;
    }
    if (series.times.size() < 2) return;
    if (spacing_of(series.times).even(kGrid)) {
      const double mean = (series.times.back() - series.times.front()) /
                          static_cast<double>(series.times.size() - 1);
      const double step = std::round(mean / kGrid) * kGrid;
      component.time_step = agreed_time_step(step, series.line + 1);
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
    groundmotions::check_peak({size, std::max(rounding, kPeakShare * size), line_of(channel, at)},
                              samples, component, errors_);
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
};

/// The acceleration of every channel of a volume 1 or 2 (caltech_volume.h), with what its header
/// states checked: unit, time step, length, peak and azimuth. Pairs of time and value at uneven
/// times are brought to an even step (uneven_samples.h).
/// @throws Error with all errors of the file.
std::vector<Component> caltech_components(const SourceFile& file, const ReadOptions& options) {
  FileErrors errors(file);
  const auto channels = caltech_channels(file, errors);
  errors.throw_if_any();
  std::vector<Component> components;
  CaltechComponents reader(file, options, errors);
  for (const CaltechChannel& channel : channels) components.push_back(reader.component_of(channel));
  errors.throw_if_any();
  return components;
}

std::string first_text(const SourceFile& file) {
  for (const std::string_view line : file.lines())
    if (!trimmed(line).empty()) return upper(trimmed(line).substr(0, 200));
  return {};
}

constexpr std::size_t kHeaderLines = 7;

struct Block {
  std::size_t first_line = 0;
  std::string text[kHeaderLines];
  std::string type;  ///< "AC", "VL", "DP"
  std::optional<double> rate, count, azimuth;
};

Block block_at(const SourceFile& file, std::size_t line) {
  Block block{.first_line = line, .text = {}, .type = {}, .rate = {}, .count = {}, .azimuth = {}};
  for (std::size_t i = 0; i < kHeaderLines && line + i < file.lines().size(); ++i) {
    const std::string text = block.text[i] = upper(file.lines()[line + i].substr(0, 200));
    if (const auto at = text.find("DATA TYPE="); at != std::string::npos)
      block.type = trimmed(text.substr(at + 10));
    if (const auto rate = number_after(text, "SAMPLES/SEC")) block.rate = rate;
    if (const auto count = number_after(text, "NO OF POINTS")) block.count = count;
    if (const auto azimuth = number_after(text, "COMPONENT")) block.azimuth = azimuth;
  }
  return block;
}

void take_facts(const SourceFile& file, const Block& block, Component& component) {
  component.name = trimmed(file.lines()[block.first_line + 1]);
  component.header = {{"station", std::string(trimmed(file.lines()[block.first_line]))},
                      {"event", std::string(trimmed(file.lines()[block.first_line + 2]))},
                      {"filter", std::string(trimmed(file.lines()[block.first_line + 3]))}};
  const bool labelled = orient_by_label(component.name, component);
  if (!labelled && block.azimuth && *block.azimuth >= 0 && *block.azimuth <= 360)
    component.azimuth = std::fmod(*block.azimuth, 360) * kRadiansPerDegree;
}

}  // namespace

bool recognises_csmip(const SourceFile& file) {
  const std::string line = first_text(file);
  return line.starts_with("UNCORRECTED ACCELEROGRAM DATA") ||
         line.starts_with("CORRECTED ACCELEROGRAM") ||
         line.starts_with("RESPONSE AND FOURIER AMPLITUDE SPECTRA");
}

/// @returns the acceleration of each channel of the file.
/// @throws Error for volume 3 (response spectra) and what caltech_components.h says.
std::vector<Component> read_csmip(const SourceFile& file, const ReadOptions& options) {
  if (first_text(file).starts_with("RESPONSE")) refuse_spectra(file.name(), "volume 3", "the .V2");
  return caltech_components(file, options);
}

bool recognises_usc(const SourceFile& file) {
  bool is_volume = false;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, file.lines().size()); ++i)
    is_volume =
        is_volume ||
        upper(file.lines()[i].substr(0, 200)).find("OF UNCORRECTED ACCELEROGRAM DATA OF VOL") !=
            std::string::npos;
  return is_volume;
}

/// @throws Error for volume 3 (response spectra) and what caltech_components.h says.
std::vector<Component> read_usc(const SourceFile& file, const ReadOptions& options) {
  const std::string first = upper(file.lines()[0].substr(0, 200));
  if (first.find("RESPONSE") != std::string::npos || first.find("SPECTR") != std::string::npos)
    refuse_spectra(file.name(), "volume 3", "volume 2");
  return caltech_components(file, options);
}

bool recognises_usc_blocks(const SourceFile& file) {
  const Block block = block_at(file, 0);
  return !block.type.empty() && block.rate;
}

/// @returns the acceleration of each component of the file.
/// @throws Error if a block has not the number of samples it states, or no block is acceleration.
std::vector<Component> read_usc_blocks(const SourceFile& file, const ReadOptions& options) {
  FileErrors errors(file);
  FieldReader fields(file, errors);
  const FortranFormat format = *fortran_format("10F8.2");
  std::vector<Component> components;
  for (std::size_t line = 0; line < file.lines().size() && !errors.any();) {
    if (trimmed(file.lines()[line]).empty()) {
      ++line;
      continue;
    }
    const Block block = block_at(file, line);
    const std::size_t first = line + 1;
    if (block.type.empty() || !block.rate || !block.count || !(*block.rate > 0) ||
        !(*block.count >= 2 && *block.count <= 1e7 && *block.count == std::floor(*block.count))) {
      errors.add(first, 1,
                 "no header of a block here: 7 lines with SAMPLES/SEC= above 0, DATA TYPE= and "
                 "NO OF POINTS= above 1");
      break;
    }
    line += kHeaderLines;
    auto values = fields.read(line, static_cast<std::size_t>(*block.count), format,
                              EmptyField::kError, "samples");
    if (block.type != "AC") {
      if (!components.empty())
        components.back().header.emplace_back("also in the file", "data type " + block.type);
      continue;
    }
    const std::size_t unit_line = first + kHeaderLines - 1;
    const auto unit =
        agreed_unit(unit_in(block.text[kHeaderLines - 1]), unit_line, options, errors);
    Component component;
    component.unit = unit.name;
    component.time_step = agreed_time_step(1 / *block.rate, first + 5, options, errors);
    component.acceleration = scaled(values, unit.to_si);
    take_facts(file, block, component);
    components.push_back(component);
  }
  if (!errors.any() && components.empty())
    errors.add(1, 1,
               "this file holds velocity (VL) or displacement (DP) only; a record must be "
               "acceleration (DATA TYPE=AC)");
  errors.throw_if_any();
  return components;
}

}  // namespace gurney::groundmotions
