// Formats with lines of text, a block of integers, a block of real numbers, then samples, all in
// fixed columns.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

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

constexpr double kLargestCount = 1e8;

// --- GeoNet, New Zealand

constexpr std::size_t kGeonetTextLines = 16, kGeonetIntegers = 40, kGeonetReals = 60,
                      kComponents = 3;
constexpr std::size_t kCountLine = 9, kUnitLine = 10, kFilterLine = 11, kNameLine = 12,
                      kPeakLine = 13;  // of the text, from 0

class GeonetReader : LayoutReader {
 public:
  using LayoutReader::LayoutReader;

  std::vector<Component> read() {
    std::vector<Component> components;
    while (skip_blank_lines() && components.size() < kComponents && !errors.any())
      components.push_back(read_block());
    if (!errors.any() && components.size() < kComponents)
      error(file.lines().size(),
            fmt::format("the file ends after {} of {} components", components.size(), kComponents));
    if (!errors.any() && line_ < file.lines().size())
      error(line_ + 1, fmt::format("more lines follow the {} components", kComponents));
    return checked(components);
  }

 private:
  bool skip_blank_lines() {
    while (line_ < file.lines().size() && is_blank(file.lines()[line_])) ++line_;
    return line_ < file.lines().size();
  }

  std::string_view text(std::size_t line) const { return file.lines()[start_ + line]; }

  Component read_block() {
    start_ = line_;
    Component component;
    if (start_ + kGeonetTextLines >= file.lines().size()) {
      error(file.lines().size(), "the file ends within the header of a component");
      return component;
    }
    line_ = start_ + kGeonetTextLines;
    integers_ = fields.read(line_, kGeonetIntegers, {10, 8, 0, 'I', "10I8"}, EmptyField::kZero,
                            "integers of the header");
    if (!errors.any())
      reals_ = fields.read(line_, kGeonetReals, {10, 8, 0, 'F', "10F8.0"}, EmptyField::kZero,
                           "real numbers of the header");
    const std::size_t count = errors.any() ? 0 : sample_count();
    if (errors.any()) return component;
    const double step = time_step();
    const AccelerationUnit in_file = unit();
    const auto accelerations = read_samples(count, "accelerations");
    const std::size_t more = read_samples(whole(integers_[34]), "velocities").size() +
                             read_samples(whole(integers_[35]), "displacements").size();
    if (errors.any()) return component;
    component = component_of(accelerations, in_file, step);
    if (more > 0) component.header.emplace_back("also in the file", "velocity and displacement");
    if (const auto peak = number_after(upper(text(kPeakLine)), "PEAK")) {
      // Printed with one decimal; from 10000 on without any, here or among the samples.
      const double rounding = std::abs(*peak) < 9999 ? 0.11 : 1.01;
      check_peak(
          {std::abs(*peak) * in_file.to_si, rounding * in_file.to_si, start_ + kPeakLine + 1},
          component.acceleration, component);
    }
    check_length(reals_[23], start_ + kGeonetTextLines + 7, component);
    if (!errors.any()) describe(component);
    return component;
  }

  std::size_t whole(double value) const {
    return value >= 0 && value <= kLargestCount ? static_cast<std::size_t>(value) : 0;
  }

  /// Integer 34, or 31 (digitised samples) in volumes that leave it empty; the text says it too.
  std::size_t sample_count() {
    const double stated = integers_[33] > 0 ? integers_[33] : integers_[30];
    const auto line = start_ + kGeonetTextLines + 4;
    if (!(stated >= 2 && stated <= kLargestCount))
      errors.add(line, 25, fmt::format("{} samples of acceleration are no record", stated));
    const auto in_text = number_after(upper(text(kCountLine)), "NUMBER OF POINTS");
    if (in_text && *in_text != stated)
      errors.add(line, 25,
                 fmt::format("the header states {} samples here, but {} in line {}", stated,
                             *in_text, start_ + kCountLine + 1));
    return whole(stated);
  }

  /// Real 26; the text says it too.
  double time_step() {
    const double stated = reals_[25];
    const std::string line = upper(text(kUnitLine));
    const auto at = line.find("INTERVALS OF") != line.npos ? number_after(line, "INTERVALS OF")
                                                           : number_after(line, " AT ");
    if (at && !(std::abs(*at - stated) <= 0.0005))  // printed with three decimals
      error(start_ + kUnitLine + 1,
            fmt::format("the time step is {} s here, but {} s in the real numbers of the "
                        "header",
                        *at, stated));
    return agreed_time_step(stated, start_ + kGeonetTextLines + 7);
  }

  /// Unit line of V1A ("in units of 1.00 mm/s/s") or peak line of V2A.
  AccelerationUnit unit() {
    const std::string line = upper(text(kUnitLine));
    const auto factor = number_after(line, "UNITS OF");
    if (!factor) return agreed_unit(unit_in(text(kPeakLine)), start_ + kPeakLine + 1);
    AccelerationUnit unit = agreed_unit(unit_in(line), start_ + kUnitLine + 1);
    if (!(*factor > 0)) error(start_ + kUnitLine + 1, fmt::format("a unit of {} mm/s/s", *factor));
    unit.to_si *= *factor;
    return unit;
  }

  std::vector<double> read_samples(std::size_t count, std::string_view what) {
    if (errors.any()) return {};
    return fields.read(line_, count, {10, 8, 0, 'F', "10F8.1"}, EmptyField::kError, what);
  }

  void describe(Component& component) {
    std::string_view label = trimmed(text(kNameLine));
    if (upper(label).starts_with("COMPONENT")) label = trimmed(label.substr(9));
    const auto name = label.substr(0, label.find_first_of(" \t"));
    component.name = name;
    orient_by_label(name, component);
    component.start_time = start_time();
    const auto fact = [&](const char* what, std::size_t line) {
      if (!trimmed(text(line)).empty()) component.header.emplace_back(what, trimmed(text(line)));
    };
    fact("title", 0);
    fact("station", 1);
    fact("site", 2);
    fact("event", 8);
    fact("filter", kFilterLine);
    fact("component", kNameLine);
    fact("peak", kPeakLine);
  }

  /// The buffer starts at the time of the header; samples put before it (real 22) are earlier.
  std::optional<double> start_time() const {
    const auto integer = [&](std::size_t i) { return static_cast<int>(integers_[i]); };
    const bool in_range =
        std::ranges::all_of(integers_, [](double x) { return std::abs(x) < 1e9; });
    if (!in_range) return {};
    const auto buffer = utc_seconds(integer(8), integer(9), integer(18), integers_[19],
                                    integers_[38], integers_[39] / 1000);
    const double before = reals_[21];
    if (!buffer || !(before >= 0 && before < 1e5)) return {};
    return *buffer - before;
  }

  std::size_t line_ = 0;   ///< that comes next, from 0
  std::size_t start_ = 0;  ///< first line of the component
  std::vector<double> integers_, reals_;
};

// --- SMC of the US Geological Survey

constexpr std::size_t kSmcTextLines = 11, kSmcIntegers = 48, kSmcReals = 50;
constexpr std::size_t kRealLine = kSmcTextLines + 6, kCommentLine = kRealLine + 10;  // from 0
constexpr AccelerationUnit kSmcUnit = {"cm/s2", 0.01};

const FortranFormat kIntegerFormat{8, 10, 0, 'I', "8I10"};
const FortranFormat kRealFormat{5, 15, 0, 'E', "5E15.7"};
const FortranFormat kSampleFormats[] = {{8, 10, 0, 'E', "8E10.4"}, {5, 14, 0, 'E', "5E14.7"}};

const char* structure_name(double code) {
  constexpr const char* kNames[] = {"a building", "a bridge", "a dam"};
  return code >= 1 && code <= 3 ? kNames[static_cast<std::size_t>(code) - 1] : "a structure";
}

class SmcReader : LayoutReader {
 public:
  using LayoutReader::LayoutReader;

  std::vector<Component> read() {
    Component component;
    check_type(component);
    agreed_unit(kSmcUnit, 1);
    read_header();
    errors.throw_if_any();
    const std::vector<double> numbers = read_numbers(component);
    errors.throw_if_any();
    is_uneven() ? take_pairs(numbers, component) : take_samples(numbers, component);
    errors.throw_if_any();
    component.unit = kSmcUnit.name;
    orient(component);
    describe(component);
    return checked({component});
  }

 private:
  bool has_integer(std::size_t i) const { return integers_[i] != integers_[0]; }
  bool has_real(std::size_t i) const {
    return std::isfinite(reals_[i]) && std::abs(reals_[i]) < 1e30 && reals_[i] != reals_[0];
  }

  /// The digit that the first line starts with.
  void check_type(Component& component) {
    const auto title = trimmed(file.lines().front());
    const std::string text = upper(title);
    const bool is_acceleration = text.find("ACCELEROGRAM") != text.npos;
    if (title[0] == '1' || title[0] == '2' || is_acceleration) return;
    if (title[0] == '0' || title[0] == '*') {
      component.warnings.push_back(fmt::format(
          "the file does not say what it holds ('{}'); taken as acceleration in cm/s2, as the "
          "format has it",
          title));
      return;
    }
    refuse(1, fmt::format("a record must be acceleration, but this file holds '{}'; take the "
                          "accelerogram of this component (type 1 or 2)",
                          title));
  }

  void read_header() {
    std::size_t line = kSmcTextLines;
    integers_ = fields.read(line, kSmcIntegers, kIntegerFormat, EmptyField::kZero,
                            "integers of the header");
    if (!errors.any())
      reals_ = fields.read(line, kSmcReals, kRealFormat, EmptyField::kZero,
                           "real numbers of the header");
    if (errors.any()) return;
    const double comments = has_integer(15) ? integers_[15] : 0;
    first_line_ = kCommentLine;
    while (first_line_ < file.lines().size() && file.lines()[first_line_].starts_with('|'))
      ++first_line_;
    const auto found = first_line_ - kCommentLine;
    if (comments != static_cast<double>(found))
      errors.add(kSmcTextLines + 2, 71,
                 fmt::format("the header states {} lines of comments, but the file has {}",
                             comments, found));
    const double count = integers_[16];
    if (!(count >= 2 && count <= kLargestCount))
      error(kSmcTextLines + 3, fmt::format("{} numbers are no record", count));
  }

  /// Without a sampling rate the numbers are pairs of time and sample.
  bool is_uneven() const { return !has_real(1); }

  std::vector<double> read_numbers(Component& component) {
    const auto count = static_cast<std::size_t>(integers_[16]);
    const FortranFormat* format = &kSampleFormats[0];
    for (const FortranFormat& candidate : kSampleFormats)
      if (fields.fits(first_line_, std::min(count, candidate.per_line), candidate))
        format = &candidate;
    std::size_t line = first_line_;
    const char* what = is_uneven() ? "numbers" : "samples";
    auto numbers = fields.read(line, count, *format, EmptyField::kError, what);
    const std::size_t end = data_end(file, line);
    const std::string more = fmt::format("more lines follow the {} {} of the header", count, what);
    if (errors.any() || line == end) return numbers;
    // Digitised files may have one line more than they state.
    if (is_uneven() && line + 1 == end)
      component.warnings.push_back(more + "; they were ignored");
    else
      error(line + 1, more);
    return numbers;
  }

  void take_samples(const std::vector<double>& values, Component& component) {
    const double rate = reals_[1];
    component.time_step = agreed_time_step(1 / rate, kRealLine + 1);
    component.acceleration = scaled(values, kSmcUnit.to_si);
    check_stated_peak(component.acceleration, component);
    check_times_of_peaks(component);
  }

  /// Reals 29 and 31: the times of the largest and the smallest sample, to a step (samples may be
  /// counted from 0 or 1) and the rounding of the print. Both must be wrong to be an error.
  void check_times_of_peaks(const Component& component) {
    const auto& a = component.acceleration;
    std::size_t stated = 0, wrong = 0;
    for (const auto& [time, value] : {std::pair<std::size_t, std::size_t>{28, 29}, {30, 31}}) {
      if (!has_real(time) || !has_real(value)) continue;
      ++stated;
      const double peak = reals_[value] * kSmcUnit.to_si;
      bool found = false;
      for (Eigen::Index i = 0; i < a.size(); ++i)
        found = found || (std::abs(static_cast<double>(i) * component.time_step - reals_[time]) <=
                              1.02 * component.time_step + 1e-3 &&
                          std::abs(a[i] - peak) <= 0.01 * std::abs(peak));
      wrong += !found;
    }
    if (stated == 0 || wrong < stated || errors.any()) return;
    error(kRealLine + 6,
          fmt::format("the times that the header states for its peaks do not fit {:g} "
                      "samples in a second (line {})",
                      reals_[1], errors.line_in_file(kRealLine + 1)));
  }

  void take_pairs(const std::vector<double>& numbers, Component& component) {
    std::vector<double> times, values;
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
      times.push_back(numbers[i]);
      values.push_back(numbers[i + 1]);
    }
    if (numbers.size() % 2 != 0)
      return error(kSmcTextLines + 3,
                   fmt::format("{} numbers are no pairs of time and sample", numbers.size()));
    component.time_step = options.time_step.value_or(kEvenTimeStep);
    try {
      component.acceleration = kSmcUnit.to_si * evenly_spaced(times, values, component.time_step);
    } catch (const Error& uneven) {
      return error(first_line_ + 1, uneven.what());
    }
    component.warnings.push_back(uneven_warning(times, component.time_step));
    check_stated_peak(scaled(values, kSmcUnit.to_si), component);
  }

  /// Reals 30 and 32: the largest and the smallest sample.
  void check_stated_peak(const Eigen::VectorXd& samples, Component& component) {
    if (!has_real(29) || !has_real(31)) return;
    const double peak = std::max(std::abs(reals_[29]), std::abs(reals_[31])) * kSmcUnit.to_si;
    // Samples have five digits.
    check_peak({peak, 1e-4 * peak, kRealLine + 6}, samples, component);
  }

  /// Integer 13 counts degrees from up, integer 14 clockwise from north.
  void orient(Component& component) {
    const std::string_view line = file.lines()[5];
    const auto at = upper(line).find("COMPONENT=");
    const auto label = at == std::string::npos ? "" : trimmed(line.substr(at + 10));
    component.name = label;
    const bool is_level = has_integer(12) && integers_[12] == 90;
    if (has_integer(12) && integers_[12] == 0) {
      component.direction = Direction::kVertical;
    } else if (has_integer(12) && integers_[12] == 180) {
      turn_up("180 degrees from up", component);
    } else if (is_level && has_integer(13) && integers_[13] >= 0 && integers_[13] <= 360) {
      component.azimuth = std::fmod(integers_[13], 360) * kRadiansPerDegree;
    } else if (!label.empty()) {
      orient_by_label(label, component);
    }
    Component by_label;
    if (label.empty() || !orient_by_label(label, by_label)) return;
    const bool is_other = by_label.direction != component.direction ||
                          (by_label.azimuth && component.azimuth &&
                           std::abs(*by_label.azimuth - *component.azimuth) > 1e-6);
    if (is_other)
      component.warnings.push_back(fmt::format(
          "the text of the header says component '{}', its numbers say {} degrees from up and {} "
          "from north; the numbers were taken",
          label, integers_[12], integers_[13]));
  }

  void describe(Component& component) {
    const auto fact = [&](const char* name, std::string_view value) {
      if (!trimmed(value).empty() && trimmed(value) != "*")
        component.header.emplace_back(name, trimmed(value));
    };
    fact("title", file.lines()[0]);
    fact("event", file.lines()[3]);
    fact("magnitude", file.lines()[4]);
    fact("station", station_of(file.lines()[5]));
    fact("location", place_of());
    fact("instrument", file.lines()[7]);
    if (has_real(32)) fact("high-pass corner [Hz]", fmt::format("{:g}", reals_[32]));
    if (has_real(34)) fact("low-pass from [Hz]", fmt::format("{:g}", reals_[34]));
    if (has_real(35)) fact("low-pass to [Hz]", fmt::format("{:g}", reals_[35]));
    component.start_time = start_time();
    if (has_integer(17) && integers_[17] == 1) {
      std::string comments;
      for (std::size_t i = kCommentLine; i < first_line_; ++i)
        comments += fmt::format(" {}", trimmed(file.lines()[i].substr(1)));
      component.warnings.push_back(
          fmt::format("the header flags a problem; its comments: {}", trimmed(comments)));
    }
  }

  /// Only if the milliseconds are known: else it is the minute of the earthquake.
  std::optional<double> start_time() const {
    if (!std::ranges::all_of(std::array<std::size_t, 6>{1, 2, 3, 4, 5, 6},
                             [&](std::size_t i) { return has_integer(i); }))
      return {};
    const double year = integers_[1], day = integers_[2];
    if (!(year >= 1900 && year < 3000 && day >= 1 && day <= 366)) return {};
    const auto new_year = utc_seconds(static_cast<int>(year), 1, 1, integers_[3], integers_[4],
                                      integers_[5] + integers_[6] / 1000);
    return new_year ? std::optional(*new_year + 86400 * (day - 1)) : std::nullopt;
  }

  /// "station = Shafter, F   component=  360": what stands before the component.
  static std::string_view station_of(std::string_view line) {
    line = line.substr(0, upper(line).find("COMPONENT="));
    const auto sign = upper(line).find("STATION");
    const auto equals = line.find('=');
    return sign < equals && equals != line.npos ? line.substr(equals + 1) : line;
  }

  /// Integers 19 (kind), 25 (floor), 27 (bridge) and 28 (dam; 0 and missing are the free field).
  std::string place_of() const {
    const bool on_bridge = has_integer(26) && integers_[26] > 0;
    const bool on_dam = has_integer(27) && integers_[27] > 0;
    if (!has_integer(18) && !on_bridge && !on_dam) return {};
    const double kind = has_integer(18) ? integers_[18] : on_bridge ? 2 : 3;
    std::string place = structure_name(kind);
    if (has_integer(24)) place += fmt::format(", floor {}", integers_[24]);
    return place;
  }

  std::vector<double> integers_, reals_;
  std::size_t first_line_ = 0;  ///< of the samples, from 0
};

}  // namespace

bool recognises_geonet(const SourceFile& file) {
  FileErrors ignored(file);
  const FieldReader fields(file, ignored);
  const std::string first = upper(file.lines().front().substr(0, 100));
  return first.find("CORRECTED ACCELEROGRAM") != first.npos &&
         file.lines().size() > kGeonetTextLines &&
         (first.find("GNS") != first.npos ||
          upper(file.lines()[1].substr(0, 100)).starts_with("SITE") ||
          fields.fits(kGeonetTextLines, 10, {10, 8, 0, 'I', "10I8"}));
}

/// @throws Error for counts, time steps and peaks that disagree, a missing component, samples that
///         are no numbers, and a file that ends early or late.
std::vector<Component> read_geonet(const SourceFile& file, const ReadOptions& options) {
  return GeonetReader(file, options).read();
}

bool recognises_smc(const SourceFile& file) {
  const auto first = trimmed(file.lines().front().substr(0, 100));
  const bool has_type =
      first == "*" || (first.size() > 2 && std::isdigit(static_cast<unsigned char>(first[0])) &&
                       first[1] == ' ' && std::isalpha(static_cast<unsigned char>(first[2])));
  if (!has_type || file.lines().size() <= kRealLine) return false;
  FileErrors ignored(file);
  const FieldReader fields(file, ignored);
  return fields.fits(kSmcTextLines, 8, kIntegerFormat) || fields.fits(kRealLine, 5, kRealFormat);
}

/// @throws Error for velocities, displacements and spectra, a sampling rate, count or peak that the
///         samples contradict, times that decrease, and a file that ends early or late.
std::vector<Component> read_smc(const SourceFile& file, const ReadOptions& options) {
  return SmcReader(file, options).read();
}

}  // namespace gurney::groundmotions
