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

constexpr std::string_view kData = "DATOS DE ACELERACION";

/// Values of the channels 1 to 6 and 7 to 12: "/V/N90E/N00E".
struct ChannelValues {
  std::vector<std::string_view> values;
  std::size_t line = 0;  ///< from 0
};

class UnamReader : public LayoutReader {
 public:
  using LayoutReader::LayoutReader;

  std::vector<Component> read() {
    find_data();
    names_ = channels("ORIENTACION");
    errors_.throw_if_any();
    check_order();
    const AccelerationUnit unit = stated_unit();
    std::size_t line = 0;
    const auto text = value("FORMATO DATOS", line);
    auto format = fortran_format(text.substr(0, text.find(' ')));
    if (!format || format->per_line != names_.values.size())
      errors_.add(
          line + 1, 1,
          fmt::format("'{}' is no format of {} numbers in a row", text, names_.values.size()));
    errors_.throw_if_any();
    const auto columns = read_table(file_, first_row_, *format, errors_);
    errors_.throw_if_any();
    std::vector<Component> components;
    for (std::size_t i = 0; i < columns.size(); ++i)
      components.push_back(component(i, unit, columns[i]));
    return components;
  }

 private:
  std::string_view optional_value(std::string_view key) const {
    std::size_t ignored = 0;
    return value_behind(file_.lines(), key, ignored).value_or("");
  }

  /// The lines with `key` for C1-C6 and, where it says something, for C7-C12.
  ChannelValues channels(std::string_view key) {
    ChannelValues result;
    bool is_first = true;
    for (std::size_t i = 0; i < data_line_; ++i) {
      const auto text = trimmed(file_.lines()[i]);
      const auto colon = text.find(':');
      if (!text.starts_with(key) || colon == text.npos || text.find("EN LA MUESTRA") != text.npos)
        continue;
      if (is_first) result.line = i;
      is_first = false;
      auto rest = trimmed(text.substr(colon + 1));
      while (!rest.empty()) {
        rest.remove_prefix(rest.starts_with('/') ? 1 : 0);
        const auto end = std::min(rest.find('/'), rest.size());
        if (!trimmed(rest.substr(0, end)).empty())
          result.values.push_back(trimmed(rest.substr(0, end)));
        rest.remove_prefix(end);
      }
    }
    if (is_first) errors_.add(fmt::format("the header lacks '{}'", key));
    return result;
  }

  /// The number of channel `i`, or of all if there is but one.
  std::optional<double> channel_number(const ChannelValues& all, std::size_t i) {
    if (all.values.empty()) return {};
    return number(all.values[all.values.size() == 1 ? 0 : std::min(i, all.values.size() - 1)]);
  }

  void find_data() {
    const auto& lines = file_.lines();
    const auto at = std::ranges::find_if(
        lines, [](std::string_view line) { return trimmed(line).starts_with(kData); });
    data_line_ = static_cast<std::size_t>(at - lines.begin());
    if (at == lines.end())
      errors_.add(lines.size(), 1, fmt::format("the file ends before '{}'", kData));
    for (std::size_t i = data_line_ + 1; i < std::min(lines.size(), data_line_ + 8); ++i)
      if (trimmed(lines[i]).starts_with("CANAL")) names_line_ = i + 1;
    if (at != lines.end() && (names_line_ == 0 || names_line_ + 1 >= lines.size()))
      errors_.add(data_line_ + 1, 1, "no row with the names of the channels above the samples");
    first_row_ =
        names_line_ +
        (names_line_ + 1 < lines.size() && trimmed(lines[names_line_ + 1]).starts_with("---") ? 2
                                                                                              : 1);
  }

  /// The row above the samples must name the channels in the order of the header.
  void check_order() {
    std::string in_header, above;
    for (const auto name : names_.values) in_header += fmt::format(" {}", name);
    std::string_view rest = trimmed(file_.lines()[names_line_]);
    while (!rest.empty()) {
      const auto end = std::min(rest.find_first_of(" \t"), rest.size());
      above += fmt::format(" {}", rest.substr(0, end));
      rest = trimmed(rest.substr(end));
    }
    if (in_header.empty() || in_header != above)
      errors_.add(names_line_ + 1, 1,
                  fmt::format("the columns are{} here, but{} in line {}", above, in_header,
                              errors_.line_in_file(names_.line + 1)));
  }

  AccelerationUnit stated_unit() {
    std::size_t line = 0;
    const auto text = value("UNIDADES DE LOS DATOS", line);
    if (!text.empty() && !unit_in(text))
      errors_.add(line + 1, 1, fmt::format("'{}' names no unit of acceleration", text));
    return agreed_unit(unit_in(text), line + 1);
  }

  Component component(std::size_t i, const AccelerationUnit& unit, const Eigen::VectorXd& samples) {
    Component component;
    component.name = names_.values[i];
    component.unit = unit.name;
    component.acceleration = unit.to_si * samples;
    set_time_step(i, component);
    check_count(i, component);
    const auto all = channels("ACEL. MAX");
    if (const auto peak = channel_number(all, i); peak && samples.size() > 1) {
      const double rounding = 1.1 * rounding_of(all.values[std::min(i, all.values.size() - 1)]);
      check_peak({std::abs(*peak) * unit.to_si, rounding * unit.to_si, all.line + 1}, component);
    }
    errors_.throw_if_any();
    orient_by_label(component.name.substr(0, component.name.find(';')), component);
    describe(component);
    return component;
  }

  void set_time_step(std::size_t i, Component& component) {
    const auto steps = channels("INTERVALO DE MUESTREO");
    const auto rates = channels("VEL. DE MUESTREO");
    const auto step = channel_number(steps, i), rate = channel_number(rates, i);
    component.time_step = agreed_time_step(step, steps.line + 1);
    if (step && rate && !(std::abs(*step * *rate - 1) <= 0.01))
      errors_.add(steps.line + 1, 1,
                  fmt::format("a time step of {} s is not that of {} samples in a second (line "
                              "{})",
                              *step, *rate, errors_.line_in_file(rates.line + 1)));
  }

  void check_count(std::size_t i, Component& component) {
    const auto counts = channels("NUM. TOTAL DE MUESTRAS");
    const auto count = channel_number(counts, i).value_or(0);
    const auto rows = component.acceleration.size();
    check_enough(static_cast<double>(rows), 0, errors_);
    if (!(static_cast<double>(rows) >= count))
      errors_.add(counts.line + 1, 1,
                  fmt::format("the header states {} samples, but the file has {} rows: it seems "
                              "to be cut",
                              count, rows));
    else if (static_cast<double>(rows) != count)
      component.warnings.push_back(fmt::format(
          "the header states {} samples, but the file has {} rows; all were taken", count, rows));
    const auto durations = channels("DURACION DEL REGISTRO");
    check_length(channel_number(durations, i).value_or(0), durations.line + 1, component);
  }

  void describe(Component& component) {
    state_facts({{"station", "NOMBRE DE LA ESTACION"},
                 {"station code", "CLAVE DE LA ESTACION"},
                 {"soil", "TIPO DE SUELO"},
                 {"event date", "FECHA DEL SISMO"},
                 {"magnitude", "MAGNITUD(ES)"},
                 {"instrument", "MODELO DEL ACELEROGRAFO"}},
                component);
    std::size_t line = 0;
    if (value_behind(file_.lines(), "CALIDAD DEL ACELEROGRAMA", line) && line + 1 < data_line_ &&
        !trimmed(file_.lines()[line + 1]).empty())
      component.header.emplace_back("quality", trimmed(file_.lines()[line + 1]));
    component.start_time = start_time();
  }

  /// The date is that of the earthquake: a first sample half a day before it is of the next day.
  std::optional<double> start_time() const {
    const std::string date(optional_value("FECHA DEL SISMO"));
    const auto at = [&](std::string_view key) {
      return utc_seconds(fmt::format("{} {}", date, optional_value(key)));
    };
    const auto first = at("HORA DE LA PRIMERA MUESTRA"), origin = at("HORA EPICENTRO");
    if (!first || !origin) return first;
    return *first + 86400 * std::round((*origin - *first) / 86400);
  }

  ChannelValues names_;
  std::size_t data_line_ = 0, names_line_ = 0, first_row_ = 0;  ///< from 0
};

}  // namespace

bool recognises_unam(const SourceFile& file) {
  const auto& lines = file.lines();
  return std::any_of(lines.begin(), lines.begin() + std::min<long>(30, std::ssize(lines)),
                     [](std::string_view line) {
                       return trimmed(line).starts_with("ARCHIVO ESTANDAR DE ACELERACION");
                     });
}

/// @throws Error for statements that are missing or disagree, fewer rows than stated, and samples
///         that are no numbers. More rows than stated are a warning.
std::vector<Component> read_unam(const SourceFile& file, const ReadOptions& options) {
  FileErrors errors(file);
  return UnamReader(file, options, errors).read();
}

}  // namespace gurney::groundmotions
