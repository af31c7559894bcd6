// Formats of one table: a header of `key: value`, then a row for each time and a column for each
// channel.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "groundmotions/formats/calendar.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

/// The format that a text begins with.
std::optional<FortranFormat> leading_format(std::string_view text) {
  return fortran_format(text.substr(0, text.find(' ')));
}

// --- CWB, Taiwan

class CwbReader : LayoutReader {
 public:
  using LayoutReader::LayoutReader;

  std::vector<Component> read() {
    const HeaderLine rate = needed("#SampleRate");
    const auto per_second = number(rate.text);
    time_step_ =
        agreed_time_step(per_second ? std::optional(1 / *per_second) : std::nullopt, rate.line);
    const HeaderLine unit_line = needed("#AmplitudeUnit");
    const AccelerationUnit unit = agreed_unit(unit_in(unit_line.text), unit_line.line);
    const HeaderLine length = needed("#RecordLength");
    read_sequence();
    const HeaderLine data = needed("#Data:");
    const auto format = leading_format(data.text);
    if (!format || format->per_line != names_.size() + 1)
      error(data.line,
            fmt::format("'{}' is no format of a time and {} samples", data.text, names_.size()));
    errors.throw_if_any();

    const auto columns = read_table(file, first_row(), *format, errors);
    errors.throw_if_any();
    check_times(columns[0], number(length.text).value_or(0), length.line);
    errors.throw_if_any();
    std::vector<Component> components;
    for (std::size_t i = 0; i < names_.size(); ++i)
      components.push_back(component(i, unit, columns[i + 1]));
    return checked(components);
  }

 private:
  struct Name {
    char letter;  ///< 'U', 'N' or 'E'
    bool is_negative;
  };

  std::size_t first_row() const {
    const auto at = std::ranges::find_if_not(file.lines(), [](std::string_view line) {
      return is_blank(line) || trimmed(line).starts_with('#');
    });
    return static_cast<std::size_t>(at - file.lines().begin());
  }

  /// "Time U(+); N(+); E(+)"
  void read_sequence() {
    const auto [text, line] = needed("#DataSequence");
    bool is_sound = text.starts_with("Time");
    for (const auto word : words_of(text.substr(is_sound ? 4 : 0), ";")) {
      const auto part = trimmed(word);
      if (part.empty() || !is_sound) continue;
      is_sound = part.size() == 4 && std::string_view("UNE").find(part[0]) != kNone &&
                 (part.substr(1) == "(+)" || part.substr(1) == "(-)") &&
                 std::ranges::find(names_, part[0], &Name::letter) == names_.end();
      if (is_sound) names_.push_back({part[0], part[2] == '-'});
    }
    if (!is_sound || names_.empty())
      error(line, fmt::format("'{}' is no sequence of Time and U, N, E with their signs", text));
  }

  void check_times(const Eigen::VectorXd& times, double length, std::size_t length_line) {
    constexpr double kTimeRounding = 0.00051;  // times have three decimals [s]
    check_enough(static_cast<double>(times.size()), 0);
    if (errors.any()) return;
    for (Eigen::Index i = 0; i < times.size(); ++i) {
      const double even = times[0] + static_cast<double>(i) * time_step_;
      if (!(std::abs(times[i] - even) <= 2 * kTimeRounding))
        return error(
            first_row() + static_cast<std::size_t>(i) + 1,
            fmt::format("time {} s where the sampling rate gives {:.6g} s", times[i], even));
    }
    const double found = static_cast<double>(times.size()) * time_step_;
    const std::string message =
        fmt::format("the header states a length of {} s, but {} rows at {} s have {:.6g} s", length,
                    times.size(), time_step_, found);
    if (!(std::abs(found - length) <= 1 + 1e-9))  // stated in whole seconds
      error(length_line, message);
    else if (std::abs(found - length) > 0.5 * time_step_)
      warning_ = message;
  }

  Component component(std::size_t i, const AccelerationUnit& unit, const Eigen::VectorXd& samples) {
    const auto& [letter, is_negative] = names_[i];
    Component component = component_of(samples, unit, time_step_);
    component.name = letter;
    if (!warning_.empty()) component.warnings.push_back(warning_);
    check_stated_peak(letter, unit, component);
    if (is_negative && letter != 'U') {
      component.acceleration = -component.acceleration;
      component.warnings.push_back(fmt::format("{}(-): the sign was turned, {} is positive", letter,
                                               letter == 'N' ? "north" : "east"));
    }
    if (is_negative && letter == 'U')
      turn_up("U(-)", component);
    else
      orient_by_label(letter == 'U' ? "UP" : std::string(1, letter), component);
    state_facts({{"station", "#StationName"},
                 {"station code", "#StationCode"},
                 {"event", "#Origin Time"},
                 {"magnitude", "#Magnitude"},
                 {"unit", "#AmplitudeUnit"},
                 {"instrument", "#InstrumentKind"}},
                component);
    component.start_time = start_time();
    return component;
  }

  /// "#AmplitudeMAX. U:    0.658~   -0.837"
  void check_stated_peak(char letter, const AccelerationUnit& unit, Component& component) {
    auto [text, line] = find(fmt::format("#AmplitudeMAX. {}", letter));
    const double rounding = 1.1 * rounding_of(text);
    const auto largest = take_number(text);
    text.remove_prefix(std::min(text.find_first_of("-+0123456789."), text.size()));
    const auto smallest = take_number(text);
    if (largest && smallest)
      check_peak({std::max(std::abs(*largest), std::abs(*smallest)) * unit.to_si,
                  rounding * unit.to_si, line},
                 component.acceleration, component);
  }

  /// "#StartTime(GMT+08): 2018/02/06-23:50:29.000"
  std::optional<double> start_time() const {
    const auto [text, line] = find("#StartTime(GMT");
    const auto local = utc_seconds(text);
    const auto zone = line > 0 ? number_after(header[line - 1], "GMT") : std::nullopt;
    if (!local || !zone || !(std::abs(*zone) <= 14)) return {};
    return *local - 3600 * *zone;
  }

  double time_step_ = 0;
  std::vector<Name> names_;
  std::string warning_;  ///< of every component
};

// --- NSMN, Turkey

class NsmnReader : LayoutReader {
 public:
  using LayoutReader::LayoutReader;

  std::vector<Component> read() {
    const HeaderLine step = needed("SAMPLING INTERVAL");
    const double time_step = agreed_time_step(number(step.text), step.line);
    const HeaderLine peak = needed("RAW PGA VALUES");
    const std::string peaks(peak.line > 0 ? header[peak.line - 1] : "");
    const AccelerationUnit unit = agreed_unit(unit_in(peaks), peak.line);
    const HeaderLine count = needed("NUMBER OF DATA");
    find_columns();
    errors.throw_if_any();
    const std::vector<double> samples = read_rows();
    const std::size_t width = names_.size();
    if (!errors.any())
      check_count({number(count.text).value_or(0), "NUMBER OF DATA", count.line},
                  samples.size() / width);
    errors.throw_if_any();
    using Table = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const Eigen::Map<const Table> table(samples.data(),
                                        static_cast<Eigen::Index>(samples.size() / width),
                                        static_cast<Eigen::Index>(width));
    std::vector<Component> components;
    for (std::size_t i = 0; i < width; ++i) {
      Component component =
          component_of(Eigen::VectorXd(table.col(static_cast<Eigen::Index>(i))), unit, time_step);
      if (const auto stated = number_after(peaks, "(" + names_[i] + ")"))
        check_peak({std::abs(*stated) * unit.to_si, 2e-6 * unit.to_si, peak.line},
                   component.acceleration, component);
      name_and_orient(names_[i], component);
      describe(component);
      components.push_back(std::move(component));
    }
    return checked(components);
  }

 private:
  void find_columns() {
    constexpr std::size_t kHeaderLines = 40;  // at most; real files have 18
    for (std::size_t i = 1; i < std::min(kHeaderLines, file.lines().size()); ++i) {
      const auto words = words_of(file.lines()[i], " \t");
      const auto is_name = [](std::string_view w) {
        return w == "N-S" || w == "E-W" || w == "U-D";
      };
      if (words.empty() || !std::ranges::all_of(words, is_name)) continue;
      names_.assign(words.begin(), words.end());
      first_row_ = i + 1;
    }
    auto sorted = names_;
    std::ranges::sort(sorted);
    if (sorted != std::vector<std::string>{"E-W", "N-S", "U-D"})
      error(std::max<std::size_t>(first_row_, 1), "no row that names the columns N-S, E-W and U-D");
  }

  std::vector<double> read_rows() {
    NumberReader reader(file, errors);
    for (std::size_t i = first_row_; i < file.lines().size(); ++i) {
      if (is_blank(file.lines()[i])) continue;
      const std::size_t found = reader.read_line(i);
      if (found != names_.size())
        error(i + 1, fmt::format("{} numbers, the row must have {}", found, names_.size()));
    }
    reader.check_end();
    return reader.values();
  }

  void describe(Component& component) const {
    state_facts({{"station", "PLACE"},
                 {"station code", "STATION ID"},
                 {"event", "EARTHQUAKE DATE"},
                 {"magnitude", "EARTHQUAKE MAGNITUDE"},
                 {"instrument", "RECORDER TYPE"}},
                component);
    // 20/07/2017 22:31:14.000000 (GMT)
    const auto time = find("RECORD TIME").text;
    if (time.size() > 10 && time[2] == '/' && time[5] == '/')
      component.start_time = day_first_utc_seconds(time.substr(0, time.find(" (GMT)")));
  }

  std::size_t first_row_ = 0;  ///< from 0
  std::vector<std::string> names_;
};

// --- UNAM, Mexico

constexpr std::string_view kData = "DATOS DE ACELERACION";

/// Values of the channels 1 to 6 and 7 to 12: "/V/N90E/N00E".
struct ChannelValues {
  std::vector<std::string_view> values;
  std::size_t line = 0;  ///< from 1; 0: there are none

  /// The number of channel `i`, or of all if there is but one.
  std::optional<double> number_of(std::size_t i) const {
    return values.empty() ? std::nullopt : number(values[std::min(i, values.size() - 1)]);
  }
};

class UnamReader : LayoutReader {
 public:
  using LayoutReader::LayoutReader;

  std::vector<Component> read() {
    find_data();
    names_ = channels("ORIENTACION");
    errors.throw_if_any();
    check_order();
    const HeaderLine unit_line = needed("UNIDADES DE LOS DATOS");
    const auto stated = unit_in(unit_line.text);
    if (!unit_line.text.empty() && !stated)
      error(unit_line.line, fmt::format("'{}' names no unit of acceleration", unit_line.text));
    const AccelerationUnit unit = agreed_unit(stated, unit_line.line);
    const HeaderLine data = needed("FORMATO DATOS");
    const auto format = leading_format(data.text);
    if (!format || format->per_line != names_.values.size())
      error(data.line, fmt::format("'{}' is no format of {} numbers in a row", data.text,
                                   names_.values.size()));
    errors.throw_if_any();
    const auto columns = read_table(file, first_row_, *format, errors);
    errors.throw_if_any();
    std::vector<Component> components;
    for (std::size_t i = 0; i < columns.size(); ++i)
      components.push_back(component(i, unit, columns[i]));
    return components;
  }

 private:
  /// The lines with `key` for C1-C6 and, where it says something, for C7-C12.
  ChannelValues channels(std::string_view key) {
    ChannelValues result;
    for (std::size_t i = 0; i < data_line_; ++i) {
      const auto text = trimmed(file.lines()[i]);
      const auto colon = text.find(':');
      if (!text.starts_with(key) || colon == kNone || text.find("EN LA MUESTRA") != kNone) continue;
      if (result.line == 0) result.line = i + 1;
      for (const auto value : words_of(text.substr(colon + 1), "/"))
        if (!is_blank(value)) result.values.push_back(trimmed(value));
    }
    if (result.line == 0) errors.add(fmt::format("the header lacks '{}'", key));
    return result;
  }

  void find_data() {
    const auto& lines = file.lines();
    const auto at = std::ranges::find_if(
        lines, [](std::string_view line) { return trimmed(line).starts_with(kData); });
    data_line_ = static_cast<std::size_t>(at - lines.begin());
    if (at == lines.end()) error(lines.size(), fmt::format("the file ends before '{}'", kData));
    for (std::size_t i = data_line_ + 1; i < std::min(lines.size(), data_line_ + 8); ++i)
      if (trimmed(lines[i]).starts_with("CANAL")) names_line_ = i + 1;
    if (at != lines.end() && (names_line_ == 0 || names_line_ + 1 >= lines.size()))
      error(data_line_ + 1, "no row with the names of the channels above the samples");
    first_row_ = names_line_ + 1;
    if (first_row_ < lines.size() && trimmed(lines[first_row_]).starts_with("---")) ++first_row_;
  }

  /// The row above the samples must name the channels in the order of the header.
  void check_order() {
    std::string in_header, above;
    for (const auto name : names_.values) in_header += fmt::format(" {}", name);
    for (const auto name : words_of(file.lines()[names_line_], kNumberBlanks))
      above += fmt::format(" {}", name);
    if (in_header.empty() || in_header != above)
      error(names_line_ + 1, fmt::format("the columns are{} here, but{} in line {}", above,
                                         in_header, errors.line_in_file(names_.line)));
  }

  Component component(std::size_t i, const AccelerationUnit& unit, const Eigen::VectorXd& samples) {
    Component component = component_of(samples, unit, time_step(i));
    component.name = names_.values[i];
    check_count(i, component);
    const ChannelValues peaks = channels("ACEL. MAX");
    if (const auto peak = peaks.number_of(i); peak && samples.size() > 1) {
      const double rounding = 1.1 * rounding_of(peaks.values[std::min(i, peaks.values.size() - 1)]);
      check_peak({std::abs(*peak) * unit.to_si, rounding * unit.to_si, peaks.line},
                 component.acceleration, component);
    }
    errors.throw_if_any();
    orient_by_label(component.name.substr(0, component.name.find(';')), component);
    describe(component);
    return component;
  }

  double time_step(std::size_t i) {
    const ChannelValues steps = channels("INTERVALO DE MUESTREO");
    const ChannelValues rates = channels("VEL. DE MUESTREO");
    const auto step = steps.number_of(i), rate = rates.number_of(i);
    const double result = agreed_time_step(step, steps.line);
    if (step && rate && !(std::abs(*step * *rate - 1) <= 0.01))
      error(steps.line,
            fmt::format("a time step of {} s is not that of {} samples in a second (line {})",
                        *step, *rate, errors.line_in_file(rates.line)));
    return result;
  }

  void check_count(std::size_t i, Component& component) {
    const ChannelValues counts = channels("NUM. TOTAL DE MUESTRAS");
    const double count = counts.number_of(i).value_or(0);
    const auto rows = static_cast<double>(component.acceleration.size());
    check_enough(rows, 0);
    if (!(rows >= count))
      error(counts.line,
            fmt::format("the header states {} samples, but the file has {} rows: it seems to be "
                        "cut",
                        count, rows));
    else if (rows != count)
      component.warnings.push_back(fmt::format(
          "the header states {} samples, but the file has {} rows; all were taken", count, rows));
    const ChannelValues durations = channels("DURACION DEL REGISTRO");
    check_length(durations.number_of(i).value_or(0), durations.line, component);
  }

  void describe(Component& component) const {
    state_facts({{"station", "NOMBRE DE LA ESTACION"},
                 {"station code", "CLAVE DE LA ESTACION"},
                 {"soil", "TIPO DE SUELO"},
                 {"event date", "FECHA DEL SISMO"},
                 {"magnitude", "MAGNITUD(ES)"},
                 {"instrument", "MODELO DEL ACELEROGRAFO"}},
                component);
    // The next line has it.
    const std::size_t quality = find("CALIDAD DEL ACELEROGRAMA").line;
    if (quality > 0 && quality < data_line_ && !is_blank(file.lines()[quality]))
      component.header.emplace_back("quality", trimmed(file.lines()[quality]));
    component.start_time = start_time();
  }

  /// The date is that of the earthquake: a first sample half a day before it is of the next day.
  std::optional<double> start_time() const {
    const auto at = [&](std::string_view key) {
      return utc_seconds(fmt::format("{} {}", find("FECHA DEL SISMO").text, find(key).text));
    };
    const auto first = at("HORA DE LA PRIMERA MUESTRA"), origin = at("HORA EPICENTRO");
    if (!first || !origin) return first;
    return *first + 86400 * std::round((*origin - *first) / 86400);
  }

  ChannelValues names_;
  std::size_t data_line_ = 0, names_line_ = 0, first_row_ = 0;  ///< from 0
};

/// Whether one of the first lines starts with this.
bool begins_a_line(const SourceFile& file, std::size_t most, std::string_view start) {
  const TextLines lines = file.lines();
  return find_line(lines.first(std::min(most, lines.size())), start).line > 0;
}

}  // namespace

bool recognises_cwb(const SourceFile& file) {
  return begins_a_line(file, 60, "#StationCode") && begins_a_line(file, 60, "#DataSequence");
}

/// @throws Error for statements that are missing or disagree, times that are not evenly spaced, a
///         length that differs from the stated one by more than a second, and samples that are no
///         numbers.
std::vector<Component> read_cwb(const SourceFile& file, const ReadOptions& options) {
  return CwbReader(file, options).read();
}

bool recognises_nsmn(const SourceFile& file) {
  return upper(file.lines().front().substr(0, 200)).find("STRONG GROUND MOTION RECORDS OF TUR") !=
         kNone;
}

/// @throws Error for statements that are missing or disagree, another number of rows than stated,
///         and samples that are no numbers.
std::vector<Component> read_nsmn(const SourceFile& file, const ReadOptions& options) {
  return NsmnReader(file, options).read();
}

bool recognises_unam(const SourceFile& file) {
  return begins_a_line(file, 30, "ARCHIVO ESTANDAR DE ACELERACION");
}

/// @throws Error for statements that are missing or disagree, fewer rows than stated, and samples
///         that are no numbers. More rows than stated are a warning.
std::vector<Component> read_unam(const SourceFile& file, const ReadOptions& options) {
  return UnamReader(file, options).read();
}

}  // namespace gurney::groundmotions
