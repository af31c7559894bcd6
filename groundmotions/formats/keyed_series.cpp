// Formats of one component: lines with keys, then its samples to the end of the file.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "groundmotions/formats/calendar.h"
#include "groundmotions/formats/header_text.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

constexpr AccelerationUnit kGal = {"cm/s2", 0.01};

/// The lines with a colon at the top of a file.
TextLines colon_lines(const SourceFile& file) {
  const auto has_none = [](std::string_view line) { return line.find(':') == kNone; };
  return {file.lines().begin(), std::ranges::find_if(file.lines(), has_none)};
}

bool has(std::string_view text, std::string_view part) { return text.find(part) != kNone; }

// --- ESM, ITACA and AFAD

struct EsmReader : LayoutReader {
  EsmReader(const SourceFile& source, const ReadOptions& given) : LayoutReader(source, given) {
    header = colon_lines(source);
  }

  std::vector<Component> read() {
    refuse_other_quantities();
    const HeaderLine step = find("SAMPLING_INTERVAL_S:"), units = find("UNITS:");
    const HeaderLine count = find("NDATA:");
    const double time_step = checked_time_step(
        {number_of(step, "SAMPLING_INTERVAL_S"), "SAMPLING_INTERVAL_S", step.line});
    const AccelerationUnit unit =
        units.text.empty() ? agreed_unit({}, 0) : checked_unit(units.text, units.line);
    Component component = read_to_end(header.size(), unit, time_step,
                                      {number_of(count, "NDATA"), "NDATA", count.line});
    const HeaderLine stream = find("STREAM:");
    name_and_orient(stream.line > 0 ? stream.text : find("COMPONENT:").text, component);
    state_facts({{"event", "EVENT_NAME:"},
                 {"event id", "EVENT_ID:"},
                 {"event date", "EVENT_DATE_YYYYMMDD:"},
                 {"event time", "EVENT_TIME_HHMMSS:"},
                 {"magnitude Mw", "MAGNITUDE_W:"},
                 {"magnitude ML", "MAGNITUDE_L:"},
                 {"network", "NETWORK:"},
                 {"location", "LOCATION:"},
                 {"station", "STATION_CODE:"},
                 {"station name", "STATION_NAME:"},
                 {"site class (EC8)", "SITE_CLASSIFICATION_EC8:"},
                 {"vs30 [m/s]", "VS30_M/S:"},
                 {"epicentral distance [km]", "EPICENTRAL_DISTANCE_KM:"},
                 {"published peak [cm/s2]", "PGA_CM/S^2:"},
                 {"baseline", "BASELINE_CORRECTION:"},
                 {"filter", "FILTER_TYPE:"},
                 {"filter order", "FILTER_ORDER:"},
                 {"low cut [Hz]", "LOW_CUT_FREQUENCY_HZ:"},
                 {"high cut [Hz]", "HIGH_CUT_FREQUENCY_HZ:"},
                 {"data type", "DATA_TYPE:"},
                 {"licence", "DATA_LICENSE:"}},
                component);
    set_start(component);
    const bool step_is_sure = check_duration(component);
    if (const HeaderLine peak = find("PGA_CM/S^2:"); !peak.text.empty()) {
      check_peak(peak, kGal, component);
      check_time_of_peak(step_is_sure, component);
    }
    warn_of_state(component);
    return checked({component});
  }

  void refuse_other_quantities() {
    const HeaderLine type = find("DATA_TYPE:"), units = find("UNITS:");
    for (const char* wrong : {"SPECTRUM", "VELOCITY", "DISPLACEMENT"})
      if (has(type.text, wrong))
        refuse(type.line,
               fmt::format("a record must be acceleration, but DATA_TYPE is '{}'; take the "
                           "acceleration file of this component (.ACC.ASC)",
                           type.text));
    if (const auto quantity = other_quantity(units.text))
      refuse(units.line,
             fmt::format("a record must be acceleration, but UNITS are '{}': {}; take the "
                         "acceleration file of this component (.ACC.ASC)",
                         units.text, *quantity));
  }

  void set_start(Component& component) const {
    constexpr const char* kKey = "DATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS";
    if (const auto text = find(std::string(kKey) + ":").text; !text.empty()) {
      component.start_time = utc_seconds(text);
      // AFAD writes the day first.
      if (!component.start_time) component.start_time = day_first_utc_seconds(text);
      if (!component.start_time)
        component.warnings.push_back(
            fmt::format("the start of the record is not known: {} must be a date and a time, got "
                        "'{}'",
                        kKey, text));
      return;
    }
    // The old header has no date of the first sample: that of the event, unless midnight is between.
    constexpr double kHalfDay = 12 * 3600, kDay = 24 * 3600;
    const auto at = [&](std::string_view key) {
      return utc_seconds(fmt::format("{}_{}", find("EVENT_DATE_YYYYMMDD:").text, find(key).text));
    };
    const auto first = at("TIME_FIRST_SAMPLE_S:"), event = at("EVENT_TIME_HHMMSS:");
    if (!first || !event) return;
    component.start_time = *first - *event > kHalfDay   ? *first - kDay
                           : *event - *first > kHalfDay ? *first + kDay
                                                        : *first;
  }

  /// The duration counts samples or steps and has three decimals.
  /// @returns whether there is one
  bool check_duration(const Component& component) {
    const HeaderLine stated = find("DURATION_S:");
    const double duration = number(stated.text).value_or(0);
    if (!(duration > 0)) return false;
    const double held = static_cast<double>(component.acceleration.size()) * component.time_step;
    if (!(std::abs(held - duration) <= 1.5 * component.time_step + 0.001 * held))
      error(stated.line,
            fmt::format("DURATION_S is {}, but {} samples at SAMPLING_INTERVAL_S {} have {:.6g} s",
                        stated.text, component.acceleration.size(), component.time_step, held));
    return true;
  }

  /// Without a duration the time of the peak is the only check of the time step.
  void check_time_of_peak(bool step_is_sure, Component& component) {
    const HeaderLine stated = find("TIME_PGA_S:");
    const auto time = number(stated.text);
    if (!time) return;
    Eigen::Index at = 0;
    const double largest = component.acceleration.cwiseAbs().maxCoeff(&at);
    const double step = component.time_step;
    // Equal peaks may be at several times; samples may be counted from 0 or 1.
    for (Eigen::Index i = 0; i < component.acceleration.size(); ++i)
      if (std::abs(static_cast<double>(i) * step - *time) <= 1.01 * step &&
          std::abs(component.acceleration[i]) >= 0.999 * largest)
        return;
    const std::string message =
        fmt::format("the file states its peak at {} s, its samples have it at {:.9g} s", *time,
                    static_cast<double>(at) * step);
    if (step_is_sure)
      component.warnings.push_back(message);
    else
      error(stated.line, message + ": SAMPLING_INTERVAL_S or TIME_PGA_S is wrong");
  }

  void warn_of_state(Component& component) const {
    if (has(find("BASELINE_CORRECTION:").text, "NOT REMOVED"))
      component.warnings.push_back("the header says BASELINE NOT REMOVED: this is a raw record");
    if (const auto depth = number(find("SENSOR_DEPTH_M:").text); depth && *depth > 0)
      component.warnings.push_back(fmt::format(
          "the sensor is {} m below the ground: this is not a motion of the surface", *depth));
  }
};

// --- SIMBAD

constexpr std::string_view kSimbadStep = "Time Increment (s)", kSimbadCount = "Number of Data";

void check_simbad_peak(LayoutReader& in, Component& component) {
  const HeaderLine peak = in.find("PGA");
  if (peak.line == 0) return;
  const auto text = in.header[peak.line - 1];
  const auto stated = in_brackets(text.substr(0, text.find(':')));
  const auto unit = acceleration_unit(stated);
  if (!unit)
    return in.error(peak.line, fmt::format("'{}' is not a unit of acceleration: {} are allowed",
                                           stated, kAccelerationUnits));
  component.header.emplace_back("published peak", fmt::format("{} {}", peak.text, unit->name));
  in.check_peak(peak, *unit, component);
}

// --- CSMNC

constexpr std::string_view kUnit = "UNIT", kPoints = "NO. OF POINTS",
                           kIntervals = "EQUALLY SPACED INTERVALS OF", kLength = "DURATION";

/// The text behind a key that stands anywhere in a line of the header, its colon and blanks apart.
HeaderLine csmnc_line(const SourceFile& file, std::string_view key) {
  constexpr std::size_t kHeaderLines = 30;  // files have 15
  for (std::size_t i = 0; i < std::min(kHeaderLines, file.lines().size()); ++i) {
    const auto line = file.lines()[i];
    const auto at = upper(line.substr(0, 400)).find(key);
    if (at == kNone) continue;
    return {trimmed(left_trimmed(line.substr(at + key.size()), " \t:.")), i + 1};
  }
  return {};
}

HeaderLine csmnc_step(const SourceFile& file) {
  const HeaderLine plural = csmnc_line(file, kIntervals);
  return plural.line > 0 ? plural : csmnc_line(file, "EQUALLY SPACED INTERVAL OF");
}

HeaderLine csmnc_component(const SourceFile& file) {
  const HeaderLine whole = csmnc_line(file, "COMPONENT");
  return whole.line > 0 ? whole : csmnc_line(file, "COMP");
}

HeaderLine first_word(const HeaderLine& stated) {
  return {stated.text.substr(0, stated.text.find_first_of(" \t")), stated.line};
}

/// The number that the text behind a key begins with; whatever follows it.
StatedNumber first_number(const HeaderLine& stated, std::string_view key, LayoutReader& in) {
  auto text = stated.text;
  const auto value = take_number(text);
  if (!value)
    in.error(stated.line, fmt::format("{} must be a number, got '{}'", key, text.substr(0, 40)));
  return {value.value_or(0), key, stated.line};
}

/// The first line (from 0) behind the header: numbers only.
std::size_t first_sample_line(const SourceFile& file, std::size_t line) {
  const auto is_number = [](std::string_view word) {
    return take_number(word) && (word.empty() || word[0] == '-');
  };
  for (; line < file.lines().size(); ++line) {
    const auto words = words_of(file.lines()[line], " \t\r");
    if (!words.empty() && std::ranges::all_of(words, is_number)) break;
  }
  return line;
}

void refuse_other_csmnc_quantities(const HeaderLine& unit, LayoutReader& in) {
  const auto line = trimmed(in.file.lines()[unit.line - 1]);
  const auto quantity = quantity_in(line);
  const auto other = other_quantity(first_word(unit).text);
  if (!other && (!quantity || quantity == "acceleration")) return;
  in.refuse(unit.line,
            fmt::format("a record must be acceleration, but this is a {} file ('{}'); take the "
                        "acceleration file of this component",
                        other ? *other : *quantity, line));
}

/// TextLines in front of the samples: earthquake, station and their facts.
void set_csmnc_facts(const SourceFile& file, std::size_t end, Component& component) {
  for (std::size_t i = 0; i < std::min(end, file.lines().size()); ++i) {
    const auto line = trimmed(file.lines()[i]);
    const std::string text = upper(line);
    if (text.starts_with("STATION:"))
      component.header.emplace_back("station", trimmed(line.substr(8)));
    else if (has(text, "EARTHQUAKE"))
      component.header.emplace_back("event", line);
    else if (!line.empty() && i > 0)
      component.header.emplace_back(fmt::format("text {}", i + 1), line);
  }
}

// --- K-NET and KiK-net

/// TextLines of the header: up to `Memo.`, or to the first number.
std::size_t knet_header_end(const SourceFile& file) {
  constexpr std::size_t kHeaderLines = 60;  // at most; NIED writes 17
  const std::size_t most = std::min(kHeaderLines, file.lines().size());
  for (std::size_t i = 0; i < most; ++i) {
    const auto line = trimmed(file.lines()[i]);
    if (lower(line.substr(0, 4)) == "memo") return i + 1;
    if (!line.empty() && has("+-.0123456789", line.substr(0, 1))) return i;
  }
  return most;
}

/// The header line that starts with one of the spellings of a key, letter case apart.
HeaderLine knet_line(const SourceFile& file, std::initializer_list<std::string_view> spellings) {
  const std::size_t end = knet_header_end(file);
  for (const auto key : spellings)
    for (std::size_t i = 0; i < end; ++i)
      if (const auto line = trimmed(file.lines()[i]); lower(line).starts_with(lower(key)))
        return {trimmed(line.substr(key.size())), i + 1};
  return {};
}

struct KnetReader : LayoutReader {
  using LayoutReader::LayoutReader;

  std::vector<Component> read() {
    checked_unit(kGal.name, line("Scale Factor").line);
    const double to_si = scale_factor();
    const double frequency = number_of(knet_line(file, {"Sampling Freq(Hz)", "Sampling Freq"}),
                                       "Sampling Freq(Hz)", "Hz");
    const double duration =
        number_of(knet_line(file, {"Duration Time(s)", "Duration Time"}), "Duration Time(s)", "s");
    const std::size_t rate_line = line("Sampling Freq").line;
    if (!errors.any() && !(frequency >= 1))
      error(rate_line, fmt::format("Sampling Freq must be at least 1 Hz, got {}", frequency));
    errors.throw_if_any();
    const double time_step = checked_time_step({1 / frequency, "1 / Sampling Freq", rate_line});
    Component component =
        read_to_end(knet_header_end(file), {kGal.name, to_si}, time_step,
                    {std::round(duration * frequency), "Duration Time times Sampling Freq",
                     line("Duration Time").line});

    const double mean = component.acceleration.mean();
    component.acceleration.array() -= mean;
    set_facts(component);
    component.header.emplace_back("offset removed",
                                  fmt::format("the mean of the whole record, {:.6g} m/s2", mean));
    const HeaderLine peak = knet_line(file, {"Max. Acc. (gal)", "Max Acc. (gal)"});
    if (!peak.text.empty()) {
      component.header.emplace_back("published peak", fmt::format("{} cm/s2", peak.text));
      check_peak(peak, kGal, component);
      refuse_other_peak(peak, component);
    }
    set_start(component);
    set_channel(component);
    return checked({component});
  }

  HeaderLine line(std::string_view key) const { return knet_line(file, {key}); }

  /// "3920(gal)/6182761" [m/s2 for one count].
  double scale_factor() {
    const HeaderLine stated = line("Scale Factor");
    if (stated.line == 0) {
      errors.add("the header has no line 'Scale Factor': the samples are raw counts without it");
      return 0;
    }
    std::string text = lower(stated.text);
    std::erase(text, ' ');
    std::string_view rest = text;
    const auto gal = take_number(rest);
    constexpr std::string_view kBetween = "(gal)/";
    const auto counts =
        rest.starts_with(kBetween) ? number(rest.substr(kBetween.size())) : std::nullopt;
    if (gal && counts && *gal > 0 && *counts > 0) return *gal / *counts * kGal.to_si;
    error(stated.line,
          fmt::format("Scale Factor must be like 3920(gal)/6182761, got '{}'", stated.text));
    return 0;
  }

  /// K-NET writes directions, KiK-net the numbers of its six channels; NIED's names of their files
  /// end in these names.
  void set_channel(Component& component) {
    struct Channel {
      std::string_view dir, name;
      bool borehole;
    };
    constexpr std::array kChannels = {
        Channel{"N-S", "NS", false}, Channel{"E-W", "EW", false}, Channel{"U-D", "UD", false},
        Channel{"1", "NS1", true},   Channel{"2", "EW1", true},   Channel{"3", "UD1", true},
        Channel{"4", "NS2", false},  Channel{"5", "EW2", false},  Channel{"6", "UD2", false}};
    const HeaderLine stated = line("Dir.");
    std::string dir = upper(stated.text);
    if (dir == "NS" || dir == "EW" || dir == "UD") dir.insert(1, "-");
    const auto channel = std::ranges::find(kChannels, dir, &Channel::dir);
    if (channel == kChannels.end())
      return error(std::max<std::size_t>(stated.line, 1),
                   fmt::format("Dir. must be N-S, E-W, U-D or 1 to 6, got '{}'", stated.text));
    component.name = channel->name;
    orient(channel->name.substr(0, 2), component);
    component.header.emplace_back("sensor", channel->borehole ? "borehole" : "surface");
    if (channel->borehole)
      component.warnings.push_back(
          fmt::format("{} is a borehole sensor of KiK-net, not a motion of the surface; the "
                      "surface files end in NS2, EW2 and UD2",
                      component.name));
  }

  void set_start(Component& component) {
    constexpr double kTriggerDelay = 15;  // in Record Time [s] (NIED, "About K-NET ASCII format")
    constexpr double kJapanTime = 9 * 3600.0;  // ahead of UTC [s]
    const HeaderLine stated = line("Record Time");
    if (stated.text.empty()) return;
    if (const auto seconds = utc_seconds(stated.text))
      component.start_time = *seconds - kTriggerDelay - kJapanTime;
    else
      error(stated.line,
            fmt::format("Record Time must be a date and a time, got '{}'", stated.text));
  }

  void set_facts(Component& component) const {
    const std::pair<const char*, HeaderLine> facts[] = {
        {"origin time (Japan)", line("Origin Time")},
        {"magnitude", line("Mag.")},
        {"epicentre latitude", line("Lat.")},
        {"epicentre longitude", knet_line(file, {"Long.", "Lon."})},
        {"depth [km]", line("Depth. (km)")},
        {"station", line("Station Code")},
        {"station latitude", line("Station Lat.")},
        {"station longitude", knet_line(file, {"Station Long.", "Station Lon."})},
        {"scale factor", line("Scale Factor")}};
    for (const auto& [name, stated] : facts)
      if (!stated.text.empty()) component.header.emplace_back(name, stated.text);
  }

  /// The mean and the peak are of these very samples: rounding explains no more than a digit.
  void refuse_other_peak(const HeaderLine& peak, const Component& component) {
    constexpr double kTooFar = 0.02;  // of the peak; the mean of all samples defines it exactly
    const auto stated = number(peak.text);
    if (!stated || errors.any()) return;
    const double held = component.acceleration.cwiseAbs().maxCoeff() / kGal.to_si;
    if (std::abs(std::abs(*stated) - held) <= kTooFar * held + rounding_of(peak.text)) return;
    error(peak.line,
          fmt::format("the file states a peak of {} gal, but its samples have {:.6g} gal: one "
                      "of them is damaged",
                      peak.text, held));
  }
};

}  // namespace

bool recognises_esm(const SourceFile& file) {
  if (!file.lines().front().starts_with("EVENT_NAME:")) return false;
  const TextLines header = colon_lines(file);
  return find_line(header, "NDATA:").line > 0 && find_line(header, "SAMPLING_INTERVAL_S:").line > 0;
}

/// @throws Error for velocities, displacements and spectra, missing or wrong header lines, a count
///         that does not match, and a peak far from that of the header.
std::vector<Component> read_esm(const SourceFile& file, const ReadOptions& options) {
  return EsmReader(file, options).read();
}

bool recognises_simbad(const SourceFile& file) {
  const TextLines header = colon_lines(file);
  return find_line(header, kSimbadStep).line > 0 && find_line(header, kSimbadCount).line > 0;
}

/// @throws Error for velocities and displacements, missing or wrong header lines, a count that does
///         not match, and a peak far from that of the header.
std::vector<Component> read_simbad(const SourceFile& file, const ReadOptions& options) {
  constexpr std::string_view kSeries = "time series in ";
  LayoutReader in(file, options);
  in.header = colon_lines(file);
  const std::size_t title = in.header.size();  // the line of it, from 0
  const auto line = title < file.lines().size() ? file.lines()[title] : std::string_view();
  const auto series = line.find(kSeries);
  if (series == kNone)
    in.refuse(title + 1,
              "the header must end in a line such as 'Acceleration time series in m/s/s'");
  const auto unit_text = trimmed(line.substr(series + kSeries.size()));
  if (const auto quantity = other_quantity(unit_text))
    in.refuse(title + 1,
              fmt::format("a record must be acceleration, but this is a {} file ('{}'); take "
                          "the .cor.acc file of this component",
                          *quantity, trimmed(line)));

  const HeaderLine step = in.find(kSimbadStep), count = in.find(kSimbadCount);
  const AccelerationUnit unit = in.checked_unit(unit_text, title + 1);
  const double time_step =
      in.checked_time_step({in.number_of(step, kSimbadStep), kSimbadStep, step.line});
  Component component = in.read_to_end(
      title + 1, unit, time_step, {in.number_of(count, kSimbadCount), kSimbadCount, count.line});
  name_and_orient(in.find("Orientation").text, component);
  in.state_facts({{"event time", "Event Date & Time"},
                  {"station", "Station Code / Name"},
                  {"network", "Network"},
                  {"processing", "Processing Info"},
                  {"filter corners [Hz]", "Filter Cut-off Frequency (Hz)"}},
                 component);
  check_simbad_peak(in, component);
  return in.checked({component});
}

bool recognises_csmnc(const SourceFile& file) {
  return csmnc_line(file, kUnit).line > 0 && csmnc_line(file, kPoints).line > 0 &&
         csmnc_step(file).line > 0 && csmnc_component(file).line > 0;
}

/// @throws Error for velocities and displacements, missing or wrong header lines, a count that does
///         not match, and a peak or a length far from that of the header.
std::vector<Component> read_csmnc(const SourceFile& file, const ReadOptions& options) {
  LayoutReader in(file, options);
  const HeaderLine unit_line = csmnc_line(file, kUnit), count = csmnc_line(file, kPoints),
                   step = csmnc_step(file);
  refuse_other_csmnc_quantities(unit_line, in);
  const AccelerationUnit unit = in.checked_unit(first_word(unit_line).text, unit_line.line);
  const double time_step = in.checked_time_step(first_number(step, kIntervals, in));
  const StatedNumber points = first_number(count, kPoints, in);
  const std::size_t first = first_sample_line(file, std::max(count.line, step.line));
  Component component = in.read_to_end(first, unit, time_step, points);

  name_and_orient(first_word(csmnc_component(file)).text, component);
  set_csmnc_facts(file, first, component);
  if (const HeaderLine peak = csmnc_line(file, "PEAK VALUE"); peak.line > 0)
    in.check_peak(first_word(peak), unit, component);
  if (const HeaderLine length = csmnc_line(file, kLength); length.line > 0)
    in.check_length(first_number(length, kLength, in).value, length.line, component);
  return in.checked({component});
}

bool recognises_knet(const SourceFile& file) {
  const auto has_line = [&](std::string_view key) { return knet_line(file, {key}).line > 0; };
  return has_line("Origin Time") && has_line("Sampling Freq") && has_line("Station Code");
}

/// The mean over the whole record is taken off, as the peak in the header assumes.
/// @throws Error for missing or wrong header lines, a count of samples that is not the duration
///         times the sampling frequency, and a peak far from that of the header.
std::vector<Component> read_knet(const SourceFile& file, const ReadOptions& options) {
  return KnetReader(file, options).read();
}

}  // namespace gurney::groundmotions
