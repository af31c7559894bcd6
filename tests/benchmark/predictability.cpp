#include <fmt/core.h>

#include <array>

#include "tests/benchmark/crowd.h"
#include "tests/benchmark/regimes.h"
#include "tests/benchmark/sections.h"

namespace gurney::benchmark {
namespace {

struct Room {
  const char* name;
  int columns, rows;
};
constexpr Room kRooms[] = {{"one between walls", 1, 1}, {"two", 2, 1}, {"ten", 5, 2}};

constexpr double kSettled = 0.01, kNearlySettled = 0.05;

struct Row {
  int runs = 0, settled = 0, nearly = 0;
};

/// A row for each verdict.
class Table {
 public:
  void add(const JudgedRun& run) {
    Row& row = rows_[static_cast<std::size_t>(run.verdict)];
    ++row.runs;
    row.settled += run.error <= kSettled;
    row.nearly += run.error <= kNearlySettled;
  }
  void print(const char* name) const {
    for (std::size_t v = 0; v < rows_.size(); ++v)
      fmt::print("{:>28} {:>12}: {:>3} runs, {:>3} settled ({:>3} within {:.0f} %)\n",
                 v == 0 ? name : "", name_of(static_cast<Predictability::Verdict>(v)),
                 rows_[v].runs, rows_[v].settled, rows_[v].nearly, 100 * kNearlySettled);
  }

 private:
  std::array<Row, 3> rows_;
};

}  // namespace

void print_predictability(int records) {
  fmt::print(
      "\nPredictability of the ventilator: {} synthetic motions a regime; runs whose peaks of "
      "displacement\nand tilt at 4 ms are within {:.0f} % ({:.0f} %) of those at 0.25 ms\n",
      records, 100 * kSettled, 100 * kNearlySettled);
  for (const Regime& regime : kRegimes) {
    const Scene scene = scene_of_regime(regime);
    Table table;
#pragma omp parallel for schedule(dynamic)
    for (int k = 0; k < records; ++k) {
      const auto run = judged_run(scene, motion_of_regime(regime, k, records));
#pragma omp critical
      if (run) table.add(*run);
    }
    table.print(regime.name);
  }
}

void print_rooms(int motions) {
  fmt::print(
      "\nTrolleys 0.15 m from each other and from walls: {} synthetic motions of 0.2 to 0.8 g; "
      "items "
      "whose peaks\nof displacement and tilt at 4 ms are within {:.0f} % ({:.0f} %) of those at "
      "0.25 ms\n",
      motions, 100 * kSettled, 100 * kNearlySettled);
  for (const Room& room : kRooms) {
    const Scene scene = crowd(room.columns, room.rows);
    Table table;
#pragma omp parallel for schedule(dynamic)
    for (int k = 0; k < motions; ++k) {
      const auto items = judged_items(scene, motion_of_regime(kRegimes[0], k, motions));
#pragma omp critical
      for (const JudgedRun& item : items) table.add(item);
    }
    table.print(room.name);
  }
}

}  // namespace gurney::benchmark
