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

constexpr std::size_t kHeaderLines = 40;  ///< at most; real files have 18

class NsmnReader : public LayoutReader {
 public:
  using LayoutReader::LayoutReader;

  std::vector<Component> read() {
    std::size_t line = 0;
    const auto step = number(value("SAMPLING INTERVAL", line));
    const double time_step = agreed_time_step(step, line + 1);
    value("RAW PGA VALUES", peak_line_);
    const std::string peaks(peak_line_ > 0 ? file_.lines()[peak_line_] : "");
    const AccelerationUnit unit = agreed_unit(unit_in(peaks), peak_line_ + 1);
    const auto count = number(value("NUMBER OF DATA", line));
    find_columns();
    errors_.throw_if_any();
    read_rows();
    if (!errors_.any())
      check_count(count.value_or(0), "NUMBER OF DATA", line + 1, samples_.size() / names_.size(),
                  errors_);
    errors_.throw_if_any();
    std::vector<Component> components;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      components.push_back(component(i, unit, peaks));
      components.back().time_step = time_step;
    }
    errors_.throw_if_any();
    return components;
  }

 private:
  void find_columns() {
    for (std::size_t i = 1; i < std::min(kHeaderLines, file_.lines().size()); ++i) {
      const auto words = words_of(file_.lines()[i], " \t");
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
      errors_.add(std::max<std::size_t>(first_row_, 1), 1,
                  "no row that names the columns N-S, E-W and U-D");
  }

  void read_rows() {
    NumberReader reader(file_, errors_);
    for (std::size_t i = first_row_; i < file_.lines().size(); ++i) {
      if (trimmed(file_.lines()[i]).empty()) continue;
      const std::size_t found = reader.read_line(i);
      if (found != names_.size())
        errors_.add(i + 1, 1,
                    fmt::format("{} numbers, the row must have {}", found, names_.size()));
    }
    reader.check_end();
    samples_ = reader.values();
  }

  Component component(std::size_t i, const AccelerationUnit& unit, const std::string& peaks) {
    Component component;
    component.name = names_[i];
    component.unit = unit.name;
    const auto columns = static_cast<Eigen::Index>(names_.size());
    using Row = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const Eigen::Map<const Row> table(
        samples_.data(), static_cast<Eigen::Index>(samples_.size()) / columns, columns);
    component.acceleration = unit.to_si * table.col(static_cast<Eigen::Index>(i));
    if (const auto peak = number_after(peaks, "(" + names_[i] + ")"))
      check_peak({std::abs(*peak) * unit.to_si, 2e-6 * unit.to_si, peak_line_ + 1}, component);
    orient(names_[i], component);
    describe(component);
    return component;
  }

  void describe(Component& component) {
    state_facts({{"station", "PLACE"},
                 {"station code", "STATION ID"},
                 {"event", "EARTHQUAKE DATE"},
                 {"magnitude", "EARTHQUAKE MAGNITUDE"},
                 {"instrument", "RECORDER TYPE"}},
                component);
    std::size_t ignored = 0;
    // Day first: 20/07/2017 22:31:14.000000 (GMT)
    std::string time(value_behind(file_.lines(), "RECORD TIME", ignored).value_or(""));
    time = time.substr(0, time.find(" (GMT)"));
    if (time.size() > 10 && time[2] == '/' && time[5] == '/')
      component.start_time = utc_seconds(fmt::format(
          "{}/{}/{}{}", time.substr(6, 4), time.substr(3, 2), time.substr(0, 2), time.substr(10)));
  }

  std::size_t peak_line_ = 0, first_row_ = 0;  ///< from 0
  std::vector<std::string> names_;
  std::vector<double> samples_;  ///< row by row
};

}  // namespace

bool recognises_nsmn(const SourceFile& file) {
  return upper(file.lines().front().substr(0, 200)).find("STRONG GROUND MOTION RECORDS OF TUR") !=
         std::string::npos;
}

/// @throws Error for statements that are missing or disagree, another number of rows than stated,
///         and samples that are no numbers.
std::vector<Component> read_nsmn(const SourceFile& file, const ReadOptions& options) {
  FileErrors errors(file);
  return NsmnReader(file, options, errors).read();
}

}  // namespace gurney::groundmotions
