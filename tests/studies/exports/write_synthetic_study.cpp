#include <fmt/format.h>

#include "studies/analysis/study_data.h"
#include "studies/statistics/fragility.h"
#include "tests/support/synthetic_study.h"

/// Writes the synthetic study to the path given and prints the fitted curves of `moved` for each
/// of its configurations, theta in SI: a line `theta beta` for each.
int main(int, char** argv) {
  using namespace gurney;
  SyntheticStudy::write(argv[1]);
  const study::StudyData data(argv[1]);
  for (std::size_t i = 0; i < data.configurations().size(); ++i) {
    const statistics::FragilityFit fit =
        statistics::fit_fragility(data.observations(0, i, data.measure("")));
    fmt::print("{} {}\n", fit.curve->theta, fit.curve->beta);
  }
}
