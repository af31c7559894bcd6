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

constexpr std::size_t kTextLines = 16, kIntegers = 40, kReals = 60, kComponents = 3;
constexpr std::size_t kCountLine = 9, kUnitLine = 10, kFilterLine = 11, kNameLine = 12,
                      kPeakLine = 13;  // of the text, from 0
constexpr double kLargestCount = 1e8;

class GeonetReader : public LayoutReader {
 public:
  using LayoutReader::LayoutReader;

  std::vector<Component> read() {
    std::vector<Component> components;
    while (skip_blank_lines() && components.size() < kComponents && !errors_.any())
      components.push_back(read_block());
    if (!errors_.any() && components.size() < kComponents)
      errors_.add(
          file_.lines().size(), 1,
          fmt::format("the file ends after {} of {} components", components.size(), kComponents));
    if (!errors_.any() && line_ < file_.lines().size())
      errors_.add(line_ + 1, 1, fmt::format("more lines follow the {} components", kComponents));
    return components;
  }

 private:
  bool skip_blank_lines() {
    while (line_ < file_.lines().size() && trimmed(file_.lines()[line_]).empty()) ++line_;
    return line_ < file_.lines().size();
  }

  std::string_view text(std::size_t line) const { return file_.lines()[start_ + line]; }

  Component read_block() {
    start_ = line_;
    Component component;
    if (start_ + kTextLines >= file_.lines().size()) {
      errors_.add(file_.lines().size(), 1, "the file ends within the header of a component");
      return component;
    }
    line_ = start_ + kTextLines;
    integers_ = fields_.read(line_, kIntegers, {10, 8, 0, 'I', "10I8"}, EmptyField::kZero,
                             "integers of the header");
    if (!errors_.any())
      reals_ = fields_.read(line_, kReals, {10, 8, 0, 'F', "10F8.0"}, EmptyField::kZero,
                            "real numbers of the header");
    const std::size_t count = errors_.any() ? 0 : sample_count();
    if (errors_.any()) return component;
    component.time_step = time_step();
    read_samples(count, component);
    if (!errors_.any()) describe(component);
    return component;
  }

  std::size_t whole(double value) const {
    return value >= 0 && value <= kLargestCount ? static_cast<std::size_t>(value) : 0;
  }

  /// Integer 34, or 31 (digitised samples) in volumes that leave it empty; the text says it too.
  std::size_t sample_count() {
    const double stated = integers_[33] > 0 ? integers_[33] : integers_[30];
    const auto line = start_ + kTextLines + 4;
    if (!(stated >= 2 && stated <= kLargestCount))
      errors_.add(line, 25, fmt::format("{} samples of acceleration are no record", stated));
    const auto in_text = number_after(upper(text(kCountLine)), "NUMBER OF POINTS");
    if (in_text && *in_text != stated)
      errors_.add(line, 25,
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
      errors_.add(start_ + kUnitLine + 1, 1,
                  fmt::format("the time step is {} s here, but {} s in the real numbers of the "
                              "header",
                              *at, stated));
    return agreed_time_step(stated, start_ + kTextLines + 7);
  }

  /// Unit line of V1A ("in units of 1.00 mm/s/s") or peak line of V2A.
  AccelerationUnit unit() {
    const std::string line = upper(text(kUnitLine));
    const auto factor = number_after(line, "UNITS OF");
    if (!factor) return agreed_unit(unit_in(text(kPeakLine)), start_ + kPeakLine + 1);
    AccelerationUnit unit = agreed_unit(unit_in(line), start_ + kUnitLine + 1);
    if (!(*factor > 0))
      errors_.add(start_ + kUnitLine + 1, 1, fmt::format("a unit of {} mm/s/s", *factor));
    unit.to_si *= *factor;
    return unit;
  }

  void read_samples(std::size_t count, Component& component) {
    const FortranFormat format{10, 8, 0, 'F', "10F8.1"};
    const auto read = [&](std::size_t number_of, std::string_view what) {
      return errors_.any() ? std::vector<double>()
                           : fields_.read(line_, number_of, format, EmptyField::kError, what);
    };
    const AccelerationUnit in_file = unit();
    component.unit = in_file.name;
    const auto values = read(count, "accelerations");
    const std::size_t velocities = read(whole(integers_[34]), "velocities").size();
    const std::size_t displacements = read(whole(integers_[35]), "displacements").size();
    if (errors_.any()) return;
    component.acceleration = scaled(values, in_file.to_si);
    if (velocities + displacements > 0)
      component.header.emplace_back("also in the file", "velocity and displacement");
    if (const auto peak = number_after(upper(text(kPeakLine)), "PEAK")) {
      // Printed with one decimal; from 10000 on without any, here or among the samples.
      const double rounding = std::abs(*peak) < 9999 ? 0.11 : 1.01;
      check_peak(
          {std::abs(*peak) * in_file.to_si, rounding * in_file.to_si, start_ + kPeakLine + 1},
          component);
    }
    check_length(reals_[23], start_ + kTextLines + 7, component);
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

}  // namespace

bool recognises_geonet(const SourceFile& file) {
  FileErrors ignored(file);
  const FieldReader fields(file, ignored);
  const std::string first = upper(file.lines().front().substr(0, 100));
  return first.find("CORRECTED ACCELEROGRAM") != first.npos && file.lines().size() > kTextLines &&
         (first.find("GNS") != first.npos ||
          upper(file.lines()[1].substr(0, 100)).starts_with("SITE") ||
          fields.fits(kTextLines, 10, {10, 8, 0, 'I', "10I8"}));
}

/// @throws Error for counts, time steps and peaks that disagree, a missing component, samples that
///         are no numbers, and a file that ends early or late.
std::vector<Component> read_geonet(const SourceFile& file, const ReadOptions& options) {
  FileErrors errors(file);
  auto components = GeonetReader(file, options, errors).read();
  errors.throw_if_any();
  return components;
}

}  // namespace gurney::groundmotions
