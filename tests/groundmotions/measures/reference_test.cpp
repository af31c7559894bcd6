#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "engine/base/error.h"
#include "groundmotions/formats/format.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/measures/cumulative.h"
#include "groundmotions/measures/peaks.h"
#include "groundmotions/measures/response_spectrum.h"

/// Real files, which may not be part of the project: a folder named by GURNEY_RECORDS with
/// reference_values.csv, one row for each component.
namespace gurney::groundmotions {
namespace {

using Eigen::VectorXd;
using Row = std::map<std::string, std::string>;

std::vector<Row> rows_of(const std::filesystem::path& path) {
  std::ifstream stream(path);
  std::vector<std::string> names;
  std::vector<Row> rows;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream cells(line);
    std::vector<std::string> row;
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
    if (names.empty()) {
      names = row;
      continue;
    }
    rows.emplace_back();
    row.resize(names.size());  // an empty last cell is not seen
    for (std::size_t i = 0; i < names.size(); ++i) rows.back()[names[i]] = row[i];
  }
  return rows;
}

double value(const Row& row, const std::string& name) { return number(row.at(name)).value(); }

/// What a user would have to say about files that say nothing themselves.
std::vector<ReadOptions> options_for(const Row& row) {
  const std::string& units = row.at("units_in_file");
  std::string unit = units.substr(0, units.find_first_of(" ;"));
  if (unit == "g/10" || unit == "raw" || unit == "counts") unit.clear();
  std::vector<ReadOptions> result = {{}};
  for (const char* columns : {"", "samples", "time,h1"}) {
    result.push_back({.unit = unit, .time_step = number(row.at("dt_s")), .columns = columns});
    result.push_back({.unit = unit, .columns = columns});
  }
  return result;
}

/// The component of the row: of those with its number of samples, that whose peak is nearest.
/// Nothing if the file cannot be read (yet). A file that says all about itself must have such a
/// component, but for pairs of time and value, which the references resample.
std::optional<Component> component_of(const std::filesystem::path& folder, const Row& row) {
  const std::vector<ReadOptions> all = options_for(row);
  for (const ReadOptions& options : all) {
    try {
      std::optional<Component> nearest;
      double least = INFINITY;
      for (const Component& each : read_components(folder / row.at("file"), options)) {
        if (static_cast<double>(each.acceleration.size()) != value(row, "npts")) continue;
        VectorXd a = each.acceleration;
        const bool counts = row.at("units_in_file").starts_with("counts");
        if (row.at("file").starts_with("sac/") || counts) a.array() -= a.mean();
        if (counts) a *= value(row, "pga_mps2") / a.cwiseAbs().maxCoeff();  // whatever its unit
        const double off = std::abs(a.cwiseAbs().maxCoeff() - value(row, "pga_mps2"));
        if (off >= least) continue;
        least = off;
        nearest = each;
        nearest->acceleration = a;
      }
      if (nearest) return nearest;
      EXPECT_TRUE(&options != &all.front() || row.at("note").find("resampled") != std::string::npos)
          << "no component has " << row.at("npts") << " samples";
    } catch (const Error&) {
    }
  }
  return {};
}

/// `a` without its least-squares straight line.
VectorXd without_line(const VectorXd& a) {
  const VectorXd t = VectorXd::LinSpaced(a.size(), -1, 1);
  return a.array() - a.mean() - t.array() * (t.dot(a) / t.squaredNorm());
}

/// The largest deviation of each quantity over all files, for the report.
struct Deviations {
  std::map<std::string, double> largest;

  void check(const std::string& name, double computed, double reference, double allowed) {
    const double off = std::abs(computed - reference);
    EXPECT_LE(off, allowed) << name << " is " << computed << ", the reference " << reference;
    double& most = largest[name];
    most = std::max(most, off / std::abs(reference));
  }
};

TEST(ReferenceValues, AgreeForEveryFileThatIsRead) {
  const char* name = std::getenv("GURNEY_RECORDS");
  if (!name) GTEST_SKIP() << "GURNEY_RECORDS names no folder of real records";
  const std::filesystem::path folder = name;
  Deviations deviations;
  int read = 0;
  std::vector<std::string> unread;
  for (const Row& row : rows_of(folder / "reference_values.csv")) {
    SCOPED_TRACE(row.at("file") + " " + row.at("component"));
    const auto component = component_of(folder, row);
    if (!component) {
      unread.push_back(row.at("file"));
      continue;
    }
    ++read;
    const double dt = component->time_step;
    const VectorXd& a = component->acceleration;
    EXPECT_NEAR(dt, value(row, "dt_s"), 1e-9);
    // Nine digits are printed; 1e-6 is room for files whose numbers are scaled on reading.
    const auto relative = [&](const std::string& column, double computed, double tolerance = 1e-6) {
      const double reference = value(row, column);
      deviations.check(column, computed, reference, tolerance * std::abs(reference));
    };
    const Peaks p = peaks(dt, a);
    relative("pga_mps2", p.acceleration);
    relative("pgv_raw_cmps", 100 * p.velocity);
    relative("pgv_lindet_cmps", 100 * peaks(dt, without_line(a)).velocity);
    relative("arias_mps", arias_intensity(dt, a));
    relative("arias_exact_mps", arias_intensity(dt, a, Rule::kExact));
    relative("cav_mps", cumulative_absolute_velocity(dt, a));
    relative("cav_exact_mps", cumulative_absolute_velocity(dt, a, Rule::kExact));
    deviations.check("d5_95_s", significant_part(dt, a, 0.05, 0.95).duration(),
                     value(row, "d5_95_s"), 1e-4 * dt);
    deviations.check("d5_75_s", significant_part(dt, a, 0.05, 0.75).duration(),
                     value(row, "d5_75_s"), 1e-4 * dt);
    const Eigen::Vector4d periods(0.2, 0.5, 1, 2);
    const auto sampled = response_spectrum(dt, a, periods);
    const auto between = response_spectrum(dt, a, periods, 0.05, PeakAt::kBetweenSamples);
    const char* texts[] = {"T0.2", "T0.5", "T1.0", "T2.0"};
    for (int i = 0; i < 4; ++i) {
      const std::string ending = std::string(texts[i]) + "_mps2";
      // Two grids of at most T/200, each of which may miss as much.
      const double dense = 1.3e-4 * (1 + p.acceleration / between.pseudo_acceleration[i]);
      relative("psa_" + ending, sampled.pseudo_acceleration[i]);
      relative("psa_dense_" + ending, between.pseudo_acceleration[i], dense);
      relative("sa_abs_" + ending, sampled.absolute_acceleration[i]);
    }
  }
  for (const auto& [quantity, most] : deviations.largest)
    std::cout << "largest deviation of " << quantity << ": " << most << "\n";
  std::cout << read << " components compared, " << unread.size() << " not read:";
  for (const std::string& file : unread) std::cout << " " << file;
  std::cout << "\n";
  EXPECT_GE(read, 143);
}

}  // namespace
}  // namespace gurney::groundmotions
