#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "engine/base/units.h"
#include "groundmotions/formats/calendar.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/formats/source_file.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/record/acceleration_unit.h"

namespace gurney::groundmotions {

namespace {

// Words of 32 bits from 0, as the SAC manual counts them.
constexpr std::size_t kDelta = 0, kDepMin = 1, kDepMax = 2, kScale = 3, kBegin = 5, kAzimuth = 57,
                      kInclination = 58, kYear = 70, kVersion = 76, kCount = 79, kFileType = 85,
                      kQuantity = 86, kEven = 105, kText = 110, kData = 158;
constexpr std::size_t kHeaderBytes = 4 * kData, kFooterBytes = 22 * 8;
constexpr int kTimeSeries = 1;
constexpr int kUnknown = 5, kDisplacement = 6, kVelocity = 7, kAcceleration = 8, kVolts = 50;
constexpr int kUndefined = -12345;

/// The words of a file in one byte order.
class SacWords {
 public:
  SacWords(std::string_view bytes, bool is_swapped) : bytes_(bytes), is_swapped_(is_swapped) {}

  int integer(std::size_t word) const { return std::bit_cast<std::int32_t>(raw(word)); }
  double real(std::size_t word) const { return std::bit_cast<float>(raw(word)); }
  bool has_real(std::size_t word) const {
    return std::isfinite(real(word)) && real(word) != kUndefined;
  }

  /// The double that starts at a byte.
  double footer(std::size_t at) const {
    std::uint64_t value;
    std::memcpy(&value, bytes_.data() + at, sizeof value);
    return std::bit_cast<double>(is_swapped_ ? __builtin_bswap64(value) : value);
  }

  /// Text number `index` of eight characters; the event's name takes two of them.
  std::string text(std::size_t index) const {
    auto field = bytes_.substr(4 * kText + 8 * index, 8);
    field = trimmed(field.substr(0, field.find('\0')));
    return field == "-12345" ? "" : std::string(field);
  }

  std::string_view bytes() const { return bytes_; }

 private:
  std::uint32_t raw(std::size_t word) const {
    std::uint32_t value;
    std::memcpy(&value, bytes_.data() + 4 * word, sizeof value);
    return is_swapped_ ? __builtin_bswap32(value) : value;
  }

  std::string_view bytes_;
  bool is_swapped_;
};

std::optional<SacWords> sac_words(std::string_view bytes) {
  if (bytes.size() < kHeaderBytes) return {};
  for (const bool is_swapped : {false, true}) {
    const SacWords words(bytes, is_swapped);
    const int version = words.integer(kVersion), type = words.integer(kFileType);
    if ((version == 6 || version == 7) && type >= 0 && type <= 100) return words;
  }
  return {};
}

void check_layout(const SacWords& words, LayoutReader& in) {
  FileErrors& errors = in.errors;
  if (words.integer(kFileType) != kTimeSeries)
    errors.add(
        fmt::format("a SAC file of type {} (a spectrum or a surface), not a time series "
                    "(IFTYPE 1)",
                    words.integer(kFileType)));
  if (words.integer(kEven) != 1)
    errors.add("unevenly spaced samples (LEVEN is not 1): bring them to even steps first");
  const int quantity = words.integer(kQuantity);
  if (quantity == kDisplacement || quantity == kVelocity || quantity == kVolts)
    errors.add(
        fmt::format("a record must be acceleration, but this file holds {} (IDEP {}); "
                    "take the acceleration, or differentiate it before",
                    quantity == kVelocity       ? "velocity"
                    : quantity == kDisplacement ? "displacement"
                                                : "volts",
                    quantity));
  else if (quantity != kAcceleration && quantity != kUnknown && quantity != kUndefined)
    errors.add(fmt::format("an unknown quantity (IDEP {})", quantity));
  const double count = words.integer(kCount);
  const std::size_t footer = words.integer(kVersion) == 7 ? kFooterBytes : 0;
  const double expected = kHeaderBytes + 4 * count + static_cast<double>(footer);
  in.check_enough(count, 0);
  if (count >= 2 && expected != static_cast<double>(words.bytes().size()))
    errors.add(
        fmt::format("{} samples make {:.0f} bytes, but the file has {}: it was cut or "
                    "changed",
                    count, expected, words.bytes().size()));
}

/// Single precision has seven digits: 0.0199999996 is 0.02. Version 7 has DELTA as double too.
double stated_step(const SacWords& words) {
  const double single = words.real(kDelta);
  if (!std::isfinite(single)) return 0;
  if (words.integer(kVersion) == 7) {
    const double precise = words.footer(words.bytes().size() - kFooterBytes);
    if (std::abs(precise - single) <= 1e-6 * std::abs(single)) return precise;
  }
  return *number(fmt::format("{:.7g}", single));
}

/// The unit of the samples [m/s2]; the header's nominal nm/s2 is seldom what a file holds.
AccelerationUnit unit_of(LayoutReader& in) {
  const auto given = acceleration_unit(in.options.unit);
  if (!given && !in.options.si_per_count)
    in.errors.add(
        fmt::format("a SAC file does not state its unit; state it as unit = \"...\" or gurney "
                    "records --unit ({}) "
                    "or, of counts, as count_m_per_s2 or gurney records --count (1e-9 for nm/s2)",
                    kAccelerationUnits));
  if (given) return *given;
  return {"counts", in.options.si_per_count.value_or(1)};
}

void orient(const SacWords& words, Component& component) {
  const double inclination = words.has_real(kInclination) ? words.real(kInclination) : kUndefined;
  const double azimuth = words.has_real(kAzimuth) ? words.real(kAzimuth) : kUndefined;
  const char last = component.name.empty() ? ' ' : component.name.back();
  const bool is_named_vertical = last == 'Z' || last == 'z';
  if (inclination == 0)
    component.direction = Direction::kVertical;
  else if (inclination == 180)
    turn_up("CMPINC 180", component);
  else if (is_named_vertical)
    component.direction = Direction::kVertical;
  else if (azimuth >= 0 && azimuth <= 360)
    component.azimuth = std::fmod(azimuth, 360) * kRadiansPerDegree;
  else if (last == 'N' || last == 'E')
    component.azimuth = (last == 'N' ? 0 : 90) * kRadiansPerDegree;
  else
    groundmotions::orient(component.name, component);
  if (is_named_vertical != (component.direction == Direction::kVertical) ||
      (is_named_vertical && inclination != 0 && inclination != 180))
    component.warnings.push_back(fmt::format(
        "the component is called '{}', but its inclination from up is {} (CMPINC)", component.name,
        inclination == kUndefined ? "not stated" : fmt::format("{:g}", inclination)));
}

/// The reference time and B, the time of the first sample after it.
std::optional<double> start_time(const SacWords& words) {
  int parts[6] = {};
  for (std::size_t i = 0; i < 6; ++i) parts[i] = words.integer(kYear + i);
  if (parts[0] > 3000 || parts[1] < 1 || parts[1] > 366 || parts[5] < 0) return {};
  const auto reference =
      utc_seconds(parts[0], 1, 1, parts[2], parts[3], parts[4] + parts[5] / 1000.0);
  if (!reference || !words.has_real(kBegin)) return {};
  return *reference + 86400.0 * (parts[1] - 1) + words.real(kBegin);
}

void check_extremes(const SacWords& words, const Eigen::VectorXd& values, Component& component) {
  if (!words.has_real(kDepMin) || !words.has_real(kDepMax)) return;
  const double smallest = values.minCoeff(), largest = values.maxCoeff();
  const double tolerance = 1e-5 * std::max(std::abs(smallest), std::abs(largest));
  if (std::abs(words.real(kDepMin) - smallest) > tolerance ||
      std::abs(words.real(kDepMax) - largest) > tolerance)
    component.warnings.push_back(
        fmt::format("the header states samples of {:.5g} to {:.5g}, but they are {:.5g} to {:.5g}",
                    words.real(kDepMin), words.real(kDepMax), smallest, largest));
}

void describe(const SacWords& words, Component& component) {
  const std::pair<const char*, std::size_t> facts[] = {
      {"station", 0}, {"network", 21}, {"instrument", 23}, {"event", 1}, {"location", 3}};
  for (const auto& [name, index] : facts)
    if (!words.text(index).empty()) component.header.emplace_back(name, words.text(index));
  component.header.emplace_back("mean of the samples [m/s2]",
                                fmt::format("{:.5g}", component.acceleration.mean()));
  if (words.has_real(kScale) && words.real(kScale) != 1)
    component.warnings.push_back(fmt::format(
        "SCALE = {:g} of the header was not applied, as SAC itself does", words.real(kScale)));
  component.start_time = start_time(words);
}

}  // namespace

bool recognises_sac(const SourceFile& file) { return sac_words(file.bytes()).has_value(); }

/// @throws Error for spectra, uneven samples, velocities, displacements and volts, a length that
///         is not that of the header, samples that are not finite, and options without a unit.
std::vector<Component> read_sac(const SourceFile& file, const ReadOptions& options) {
  LayoutReader in(file, options);
  const SacWords words = *sac_words(file.bytes());
  check_layout(words, in);
  in.errors.throw_if_any();
  const double time_step = in.agreed_time_step(stated_step(words), 1);
  const AccelerationUnit unit = unit_of(in);
  Eigen::VectorXd values(words.integer(kCount));
  for (Eigen::Index i = 0; i < values.size(); ++i)
    values[i] = words.real(kData + static_cast<std::size_t>(i));
  if (!values.allFinite()) in.errors.add("not all samples are finite numbers");
  in.errors.throw_if_any();

  Component component = component_of(values, unit, time_step);
  component.name = words.text(20);
  if (words.integer(kQuantity) != kAcceleration)
    component.warnings.push_back(
        "the header does not say that the samples are acceleration (IDEP)");
  check_extremes(words, values, component);
  orient(words, component);
  describe(words, component);
  return {component};
}

}  // namespace gurney::groundmotions
