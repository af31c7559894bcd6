#pragma once

#include <vector>

#include "engine/response/settled.h"
#include "tests/benchmark/workload.h"

namespace gurney::benchmark {

/// An item of the catalogue, the first casters of it braked, under motions of a range of peaks.
struct SettledRegime {
  const char* name;
  const char* item;
  std::size_t brakes;
  double lowest_g, highest_g;
  double vertical_ratio;  ///< of the vertical peak to that of the horizontal
  double wall_x, wall_y;  ///< inner faces of walls from the item's middle; 0: there are none [m]
};

inline constexpr SettledRegime kSettledRegimes[] = {
    {"ventilator, free", "icu_ventilator", 0, 0.2, 0.8, 0.5, 0, 0},
    {"ventilator between walls", "icu_ventilator", 0, 0.2, 0.8, 0.5, 0.574, 0.524},
    {"bed between walls", "hospital_bed", 0, 0.2, 0.8, 0.5, 1.3, 0.76},
    {"ventilator, half locked", "icu_ventilator", 2, 0.2, 0.8, 0.5, 0, 0},
    {"ventilator, vertical 1.1 to 2 g", "icu_ventilator", 0, 0.45, 0.8, 2.5, 0, 0},
    {"bed, half locked, vertical 1.1 to 2 g", "hospital_bed", 2, 0.45, 0.8, 2.5, 0, 0},
    {"ventilator, braked, weak motion", "icu_ventilator", 4, 0.05, 0.2, 0.5, 0, 0}};

/// A run at 4 ms with the labels of its demands.
struct LabelledRun {
  Predictability::Verdict verdict = Predictability::Verdict::kChaotic;
  std::vector<SettledDemand> demands;  ///< empty: a repetition failed
  std::vector<double> errors;          ///< relative, against 0.0625 ms
};

/// The k-th of `motions` motions of a regime.
LabelledRun labelled_run(const SettledRegime& regime, int k, int motions);

}  // namespace gurney::benchmark
