#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "groundmotions/formats/calendar.h"
#include "groundmotions/formats/fortran_fields.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

constexpr std::size_t kHeaderLines = 60;  ///< at most; NIED writes 17
constexpr double kPeakTooFar = 0.02;  ///< of the peak; the mean of all samples defines it exactly
constexpr double kTriggerDelay = 15;  ///< in Record Time [s] (NIED, "About K-NET ASCII format")
constexpr double kJapanTime = 9 * 3600.0;  ///< ahead of UTC [s]
constexpr AccelerationUnit kGal = {"cm/s2", 0.01};

struct Entry {
  std::string_view value;
  std::size_t line = 0;  ///< from 1; 0: not there
};

/// Lines of the header: up to `Memo.`, or to the first number.
std::size_t header_end(const SourceFile& file) {
  const std::size_t most = std::min(kHeaderLines, file.lines().size());
  for (std::size_t i = 0; i < most; ++i) {
    const auto line = trimmed(file.lines()[i]);
    if (lower(line.substr(0, 4)) == "memo") return i + 1;
    if (!line.empty() && std::string_view("+-.0123456789").find(line[0]) != line.npos) return i;
  }
  return most;
}

/// The header line that starts with `key`, letter case apart.
Entry find(const SourceFile& file, std::string_view key) {
  for (std::size_t i = 0; i < header_end(file); ++i)
    if (const auto line = trimmed(file.lines()[i]); lower(line).starts_with(lower(key)))
      return {trimmed(line.substr(key.size())), i + 1};
  return {};
}

/// @param key, other  spellings of the key; @param unit  what may follow the number
double number_at(const SourceFile& file, std::string_view key, std::string_view other,
                 std::string_view unit, FileErrors& errors) {
  Entry entry = find(file, key);
  if (entry.line == 0) entry = find(file, other);
  if (entry.line == 0) {
    errors.add(fmt::format("the header has no line '{}'", key));
    return 0;
  }
  std::string_view rest = entry.value;
  const auto value = take_number(rest);
  rest = trimmed(rest);
  if (value && (rest.empty() || lower(rest) == lower(unit))) return *value;
  errors.add(entry.line, 1, fmt::format("{} must be a number, got '{}'", key, entry.value));
  return 0;
}

/// "3920(gal)/6182761" [m/s2 for one count].
double scale_factor(const SourceFile& file, FileErrors& errors) {
  const Entry entry = find(file, "Scale Factor");
  if (entry.line == 0) {
    errors.add("the header has no line 'Scale Factor': the samples are raw counts without it");
    return 0;
  }
  std::string text = lower(entry.value);
  std::erase(text, ' ');
  std::string_view rest = text;
  const auto gal = take_number(rest);
  constexpr std::string_view kBetween = "(gal)/";
  if (gal && rest.starts_with(kBetween)) {
    rest.remove_prefix(kBetween.size());
    const auto counts = number(rest);
    if (counts && *gal > 0 && *counts > 0) return *gal / *counts * kGal.to_si;
  }
  errors.add(entry.line, 1,
             fmt::format("Scale Factor must be like 3920(gal)/6182761, got '{}'", entry.value));
  return 0;
}

struct Channel {
  std::string_view dir, name;
  bool borehole;
};

/// K-NET writes directions, KiK-net the numbers of its six channels; NIED's names of their files
/// end in these names.
constexpr std::array kChannels = {
    Channel{"N-S", "NS", false}, Channel{"E-W", "EW", false}, Channel{"U-D", "UD", false},
    Channel{"1", "NS1", true},   Channel{"2", "EW1", true},   Channel{"3", "UD1", true},
    Channel{"4", "NS2", false},  Channel{"5", "EW2", false},  Channel{"6", "UD2", false}};

void set_channel(const SourceFile& file, Component& component, FileErrors& errors) {
  const Entry entry = find(file, "Dir.");
  std::string dir = upper(entry.value);
  if (dir == "NS" || dir == "EW" || dir == "UD") dir.insert(1, "-");
  const auto channel = std::ranges::find(kChannels, dir, &Channel::dir);
  if (channel == kChannels.end()) {
    errors.add(std::max<std::size_t>(entry.line, 1), 1,
               fmt::format("Dir. must be N-S, E-W, U-D or 1 to 6, got '{}'", entry.value));
    return;
  }
  component.name = channel->name;
  orient(channel->name.substr(0, 2), component);
  component.header.emplace_back("sensor", channel->borehole ? "borehole" : "surface");
  if (channel->borehole)
    component.warnings.push_back(fmt::format(
        "{} is a borehole sensor of KiK-net, not a motion of the surface; the surface files end in "
        "NS2, EW2 and UD2",
        component.name));
}

void set_start(const SourceFile& file, Component& component, FileErrors& errors) {
  const Entry entry = find(file, "Record Time");
  if (entry.value.empty()) return;
  const auto seconds = utc_seconds(entry.value);
  if (!seconds)
    errors.add(entry.line, 1,
               fmt::format("Record Time must be a date and a time, got '{}'", entry.value));
  else
    component.start_time = *seconds - kTriggerDelay - kJapanTime;
}

void set_facts(const SourceFile& file, Component& component) {
  constexpr std::array<std::array<std::string_view, 3>, 9> kFacts = {
      {{"origin time (Japan)", "Origin Time", ""},
       {"magnitude", "Mag.", ""},
       {"epicentre latitude", "Lat.", ""},
       {"epicentre longitude", "Long.", "Lon."},
       {"depth [km]", "Depth. (km)", ""},
       {"station", "Station Code", ""},
       {"station latitude", "Station Lat.", ""},
       {"station longitude", "Station Long.", "Station Lon."},
       {"scale factor", "Scale Factor", ""}}};
  for (const auto& [name, key, other] : kFacts) {
    Entry entry = find(file, key);
    if (entry.line == 0 && !other.empty()) entry = find(file, other);
    if (!entry.value.empty()) component.header.emplace_back(name, entry.value);
  }
}

/// The mean and the peak are of these very samples: rounding explains no more than a digit.
void refuse_other_peak(std::string_view text, std::size_t line, const Component& component,
                       FileErrors& errors) {
  const auto stated = number(text);
  if (!stated || errors.any()) return;
  const double held = component.acceleration.cwiseAbs().maxCoeff() / kGal.to_si;
  const double rounding = rounding_of(text);
  if (std::abs(std::abs(*stated) - held) <= kPeakTooFar * held + rounding) return;
  errors.add(line, 1,
             fmt::format("the file states a peak of {} gal, but its samples have {:.6g} gal: one "
                         "of them is damaged",
                         text, held));
}

}  // namespace

bool recognises_knet(const SourceFile& file) {
  return find(file, "Origin Time").line > 0 && find(file, "Sampling Freq").line > 0 &&
         find(file, "Station Code").line > 0;
}

/// The mean over the whole record is taken off, as the peak in the header assumes.
/// @throws Error for missing or wrong header lines, a count of samples that is not the duration
///         times the sampling frequency, and a peak far from that of the header.
std::vector<Component> read_knet(const SourceFile& file, const ReadOptions& options) {
  FileErrors errors(file);
  Component component;
  const Entry scale = find(file, "Scale Factor");
  component.unit = checked_unit(kGal.name, scale.line, options, errors).name;
  const double to_si = scale_factor(file, errors);
  const double frequency = number_at(file, "Sampling Freq(Hz)", "Sampling Freq", "Hz", errors);
  const double duration = number_at(file, "Duration Time(s)", "Duration Time", "s", errors);
  const Entry rate = find(file, "Sampling Freq");
  if (!errors.any() && !(frequency >= 1))
    errors.add(rate.line, 1, fmt::format("Sampling Freq must be at least 1 Hz, got {}", frequency));
  errors.throw_if_any();
  component.time_step =
      checked_time_step(1 / frequency, "1 / Sampling Freq", rate.line, options, errors);

  NumberReader reader(file, errors);
  read_to_end(file, header_end(file), reader);
  const auto& counts = reader.values();
  if (!errors.any())
    check_count(std::round(duration * frequency), "Duration Time times Sampling Freq",
                find(file, "Duration Time").line, counts.size(), errors);
  errors.throw_if_any();

  component.acceleration = scaled(counts, to_si);
  const double mean = component.acceleration.mean();
  component.acceleration.array() -= mean;
  set_facts(file, component);
  component.header.emplace_back("offset removed",
                                fmt::format("the mean of the whole record, {:.6g} m/s2", mean));
  Entry peak = find(file, "Max. Acc. (gal)");
  if (peak.line == 0) peak = find(file, "Max Acc. (gal)");
  if (!peak.value.empty()) {
    component.header.emplace_back("published peak", fmt::format("{} cm/s2", peak.value));
    check_peak(peak.value, kGal, peak.line, component, errors);
    refuse_other_peak(peak.value, peak.line, component, errors);
  }
  set_start(file, component, errors);
  set_channel(file, component, errors);
  errors.throw_if_any();
  return {component};
}

}  // namespace gurney::groundmotions
