#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"
#include "groundmotions/formats/fortran_fields.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

constexpr std::size_t kMaxHeaderLines = 40;  ///< 27 in the files of this volume
constexpr double kRateTolerance = 0.01;      ///< the duration may count steps or samples

bool starts_channel(std::string_view line) {
  return upper(line.substr(0, 20)).starts_with("* VOL");
}

class BhrcReader : public LayoutReader {
 public:
  using LayoutReader::LayoutReader;

  /// @param line  index from 0 of the channel's first line, of the line behind it afterwards
  Component read(std::size_t& line) {
    Component component;
    first_ = line;
    text_.clear();
    if (upper(file_.lines()[line]).find("VOL1") == kNone) {
      errors_.add(line + 1, 1, "only volume 1 (VOL1DS) of BHRC is read");
      return component;
    }
    const FortranFormat format = *fortran_format("10E13.6");
    const std::size_t end = std::min(file_.lines().size(), first_ + kMaxHeaderLines);
    for (; line < end && !fields_.fits(line, 10, format); ++line)
      text_.push_back(upper(file_.lines()[line]));
    const auto points = find("NO. OF POINTS"), unit_line = find("UNITS ARE");
    const auto count = points ? number_after(text_[*points], "NO. OF POINTS") : std::nullopt;
    if (line == end || !count || !(*count >= 2 && *count <= 1e7 && *count == std::floor(*count))) {
      errors_.add(first_ + 1, 1,
                  "this channel has no header with NO. OF POINTS = (a whole number above 1) and "
                  "samples in 10E13.6 within 40 lines");
      return component;
    }
    const auto unit = agreed_unit(unit_line ? unit_in(text_[*unit_line]) : std::nullopt,
                                  first_ + unit_line.value_or(0) + 1);
    const auto values =
        fields_.read(line, static_cast<std::size_t>(*count), format, EmptyField::kError, "samples");
    component.unit = unit.name;
    take_time_step(*points, *count, component);
    if (errors_.any()) return component;
    component.acceleration = scaled(values, unit.to_si);
    orient(component);
    return component;
  }

 private:
  std::optional<std::size_t> find(std::string_view key) const {
    for (std::size_t i = 0; i < text_.size(); ++i)
      if (text_[i].find(key) != kNone) return i;
    return {};
  }

  /// The duration is that of all samples. Real number 9 is the rate: the first of the second line
  /// with exponents.
  void take_time_step(std::size_t points, double count, Component& component) {
    const auto duration = number_after(text_[points], "DURATION");
    std::optional<double> step;
    if (duration && *duration > 0) step = *duration / count;
    std::size_t exponents = 0;
    for (std::size_t i = points; i < text_.size(); ++i) {
      if (text_[i].find("E+0") == kNone || ++exponents != 2) continue;
      std::string_view rest = trimmed(text_[i]);
      const auto rate = take_number(rest);
      if (!rate || !(*rate > 0)) continue;
      if (step && std::abs(1 / *rate - *step) > kRateTolerance * *step)
        component.warnings.push_back(fmt::format(
            "the header states {} samples per second, but also {} samples in {} s, which was taken",
            *rate, count, *duration));
      else
        step = 1 / *rate;
    }
    component.time_step = agreed_time_step(step, first_ + points + 1);
  }

  /// "COMP L1" names the component, "Azimuth L 50    T 140" its direction.
  void orient(Component& component) {
    if (const auto at = find("COMP "))
      component.name = trimmed(std::string_view(text_[*at]).substr(5));
    if (component.name.starts_with("V")) {
      component.direction = Direction::kVertical;
    } else if (const auto at = find("AZIMUTH"); at && !component.name.empty()) {
      const auto azimuths = std::string_view(text_[*at]).substr(text_[*at].find("AZIMUTH") + 7);
      const auto degrees = number_after(azimuths, fmt::format(" {} ", component.name[0]));
      if (degrees && *degrees >= 0 && *degrees <= 360)
        component.azimuth = std::fmod(*degrees, 360) * kRadiansPerDegree;
    }
    component.header.emplace_back("volume", "1 (uncorrected)");
    for (const auto& [name, key] :
         {std::pair{"event", "EPICENTER"}, std::pair{"station", "STATION"},
          std::pair{"origin time", "ORIGIN TIME"}})
      if (const auto at = find(key))
        component.header.emplace_back(name, trimmed(file_.lines()[first_ + *at]));
  }

  std::size_t first_ = 0;
  std::vector<std::string> text_;
};

}  // namespace

bool recognises_bhrc(const SourceFile& file) {
  if (!starts_channel(file.lines()[0])) return false;
  for (std::size_t i = 1; i < std::min<std::size_t>(13, file.lines().size()); ++i)
    if (upper(file.lines()[i].substr(0, 20)).starts_with("COMP ")) return true;
  return false;
}

/// @returns L, V and T as the file has them.
/// @throws Error for other volumes, a wrong count, an unknown unit or text among the samples.
std::vector<Component> read_bhrc(const SourceFile& file, const ReadOptions& options) {
  FileErrors errors(file);
  BhrcReader reader(file, options, errors);
  std::vector<Component> components;
  for (std::size_t line = 0; line < file.lines().size() && !errors.any();) {
    const auto text = trimmed(file.lines()[line]);
    if (starts_channel(text)) {
      components.push_back(reader.read(line));
    } else if (text.empty() || text.starts_with("/&")) {
      ++line;
    } else {
      errors.add(line + 1, 1,
                 fmt::format("the samples of this channel end here, but neither the next channel "
                             "nor the end of the file follows: '{}'",
                             text.substr(0, 60)));
    }
  }
  errors.throw_if_any();
  return components;
}

}  // namespace gurney::groundmotions
