#include "groundmotions/hazard/disaggregation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "engine/base/csv_row.h"
#include "engine/base/error.h"
#include "engine/base/number_text.h"
#include "engine/base/units.h"
#include "engine/config/range.h"
#include "groundmotions/formats/source_file.h"
#include "groundmotions/hazard/usgs_answer.h"

namespace gurney::groundmotions {
namespace {

using config::Range;

const Range kLevels = Range::positive();  ///< [g]
const Range kMagnitudes = Range::positive();
const Range kDistances = Range::not_negative();  ///< [km]

bool same(double a, double b) { return std::abs(a - b) <= 1e-5 * b; }  // files have six digits

/// The one of several that is wanted; without a wish the only one.
std::size_t chosen(const std::string& path, const std::string& key,
                   const std::vector<double>& known, const std::optional<double>& wanted) {
  std::vector<double> fitting;
  for (const double each : known)
    if (!wanted || same(each, *wanted)) fitting.push_back(each);
  require(fitting.size() == 1,
          fmt::format("{}: {}: must be one of {}", path,
                      wanted ? fmt::format("{} = {:g}", key, *wanted) : key + " is not stated",
                      fmt::join(known, ", ")));
  return static_cast<std::size_t>(std::ranges::find(known, fitting[0]) - known.begin());
}

Disaggregation read_usgs(const std::string& path, const DisaggregationRequest& request) {
  require(!request.poe, path + ": poe: the answer of the USGS is for one return period");
  const UsgsAnswer answer(path);
  std::vector<UsgsDisaggregation> found;
  std::vector<double> periods;
  for (const UsgsDisaggregation& each : answer.disaggregations()) {
    if (each.measure.period < 0) continue;
    found.push_back(each);
    periods.push_back(each.measure.period);
  }
  require(!found.empty(), path + ": has no disaggregation of SA at a period");
  const UsgsDisaggregation& of = found[chosen(path, "period_s", periods, request.period)];
  const std::string mean = "Mean";
  return {
      of.measure.period,
      answer.summed_up(of, "aggregation targets", {"ground motion", "Exceedance IML"}, kLevels) *
          kStandardGravity,
      answer.summed_up(of, mean, {"m"}, kMagnitudes), answer.summed_up(of, mean, {"r"}, kDistances),
      answer.summed_up(of, mean, {"\u03b5\u2080"}, Range::any())};  // epsilon_0
}

constexpr std::array<const char*, 7> kColumns = {"imt", "iml", "poe", "mag", "dist", "eps", "mean"};
enum Column { kImt, kIml, kPoe, kMag, kDist, kEps, kValue };

Range range_of(std::size_t column) {
  return column == kIml    ? kLevels
         : column == kMag  ? kMagnitudes
         : column == kDist ? kDistances
                           : Range::any();
}

/// Indices of kColumns in a file; eps may be missing.
std::array<std::optional<std::size_t>, 7> columns_of(const std::vector<CsvCell>& titles) {
  std::array<std::optional<std::size_t>, 7> columns;
  std::vector<std::size_t> realizations;
  for (std::size_t i = 0; i < titles.size(); ++i) {
    const auto known = std::ranges::find(kColumns, titles[i].text);
    if (known != kColumns.end()) columns[static_cast<std::size_t>(known - kColumns.begin())] = i;
    if (titles[i].text.starts_with("rlz")) realizations.push_back(i);
  }
  if (!columns[kValue] && realizations.size() == 1) columns[kValue] = realizations[0];
  return columns;
}

/// Earthquakes of one magnitude and distance, and their part.
struct Bin {
  double period, iml, poe, magnitude, distance, epsilon, rate;
};

class OpenQuakeFile {
 public:
  explicit OpenQuakeFile(const std::string& path) : file_(path), errors_(file_) {
    for (std::size_t i = 0; i < file_.lines().size(); ++i) {
      const std::string_view line = file_.lines()[i];
      if (line.empty() || line.starts_with('#')) continue;
      const std::vector<CsvCell> cells = csv_row(line);
      if (titles_.empty())
        read_titles(cells, i + 1);
      else
        read_bin(cells, i + 1);
    }
    if (!errors_.any() && bins_.empty()) errors_.add("has no disaggregation of SA at a period");
    errors_.throw_if_any();
  }

  Disaggregation mean(const DisaggregationRequest& request) {
    keep("period_s", request.period, &Bin::period);
    keep("poe", request.poe, &Bin::poe);
    Disaggregation mean;
    mean.period = bins_[0].period;
    mean.acceleration = bins_[0].iml * kStandardGravity;
    double sum = 0, epsilon = 0;
    for (const Bin& bin : bins_) {
      sum += bin.rate;
      mean.magnitude += bin.rate * bin.magnitude;
      mean.distance += bin.rate * bin.distance;
      epsilon += bin.rate * bin.epsilon;
    }
    require(sum > 0, file_.name() + ": no earthquake exceeds the intensity");
    mean.magnitude /= sum;
    mean.distance /= sum;
    if (columns_[kEps]) mean.epsilon = epsilon / sum;
    return mean;
  }

 private:
  void read_titles(const std::vector<CsvCell>& cells, std::size_t line) {
    titles_ = cells;
    columns_ = columns_of(cells);
    for (const std::size_t each : {kImt, kIml, kPoe, kMag, kDist, kValue})
      if (!columns_[each])
        errors_.add(
            line, 1,
            fmt::format("is no disaggregation of OpenQuake by magnitude and distance: has no "
                        "column '{}'{}",
                        kColumns[each], each == kValue ? ", and not one realization" : ""));
    errors_.throw_if_any();
  }

  void read_bin(const std::vector<CsvCell>& cells, std::size_t line) {
    if (cells.size() != titles_.size())
      return errors_.add(line, 1,
                         fmt::format("has {} values for {} columns", cells.size(), titles_.size()));
    const PublishedMeasure measure = published_measure(cells[*columns_[kImt]].text);
    if (measure.period < 0) return;
    std::array<double, 7> values{};
    for (const std::size_t each : {kIml, kPoe, kMag, kDist, kEps, kValue}) {
      if (!columns_[each]) continue;
      const CsvCell& cell = cells[*columns_[each]];
      const auto value = number(cell.text);
      const bool is_poe = each == kPoe || each == kValue;
      if (!value || !range_of(each).contains(*value) || (is_poe && !(*value >= 0 && *value < 1)))
        errors_.add(line, cell.column,
                    fmt::format("{} '{}': must be {}", titles_[*columns_[each]].text, cell.text,
                                is_poe ? "a probability below 1" : range_of(each).text()));
      else
        values[each] = *value;
    }
    const double level =
        levels_.try_emplace({measure.period, values[kPoe]}, values[kIml]).first->second;
    if (values[kIml] != level)
      errors_.add(
          line, cells[*columns_[kIml]].column,
          fmt::format("iml {:g}: must be {:g}, as of the other rows of SA({:g}) and poe {:g}",
                      values[kIml], level, measure.period, values[kPoe]));
    bins_.push_back({measure.period, values[kIml], values[kPoe], values[kMag], values[kDist],
                     values[kEps], -std::log1p(-values[kValue])});
  }

  /// Keeps the bins of one period, or of one probability.
  void keep(const std::string& key, const std::optional<double>& wanted, double Bin::*member) {
    std::vector<double> known;
    for (const Bin& bin : bins_)
      if (std::ranges::find(known, bin.*member) == known.end()) known.push_back(bin.*member);
    const double value = known[chosen(file_.name(), key, known, wanted)];
    std::erase_if(bins_, [&](const Bin& bin) { return bin.*member != value; });
  }

  SourceFile file_;
  FileErrors errors_;
  std::vector<CsvCell> titles_;
  std::array<std::optional<std::size_t>, 7> columns_;
  std::map<std::pair<double, double>, double> levels_;  ///< by period and poe
  std::vector<Bin> bins_;
};

}  // namespace

Disaggregation read_disaggregation(const std::string& path, const DisaggregationRequest& request) {
  return path.ends_with(".json") ? read_usgs(path, request) : OpenQuakeFile(path).mean(request);
}

}  // namespace gurney::groundmotions
