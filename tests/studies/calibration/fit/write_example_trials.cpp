// Writes the trials of studies/calibration/example into a folder: all of them SIMULATED.
// usage: write_example_trials FOLDER
#include <cmath>
#include <filesystem>
#include <fstream>

#include "engine/base/random/normal_draw.h"
#include "engine/base/units.h"
#include "studies/calibration/trials/trial_file.h"
#include "tests/studies/calibration/fit/virtual_pulls.h"

namespace {

using namespace gurney;
using namespace gurney::calibration;

constexpr double kScatter = 0.03;  // of ln Cr between trials

class Writer {
 public:
  explicit Writer(std::filesystem::path folder) : folder_(std::move(folder)) {}

  void write(const std::string& name, Trial trial, double end, double factor = 1) {
    trial = with_noise(std::move(trial), 2026, ++stream_);
    for (double& x : trial.signals.displacement) x *= factor;
    for (auto series : {&TrialSignals::time, &TrialSignals::force, &TrialSignals::displacement})
      if (auto& values = trial.signals.*series; !values.empty())
        values.resize(std::min(values.size(), static_cast<std::size_t>(end * 120)));
    std::ofstream(folder_ / (name + ".csv"))
        << trial_file_text(trial,
                           "SYNTHETIC: made by tests/studies/calibration/"
                           "write_example_trials, nothing of it is measured");
  }

  double scattered(double resistance) {
    return resistance * std::exp(kScatter * normal_draw(2026, 1000, ++stream_));
  }

 private:
  std::filesystem::path folder_;
  std::uint64_t stream_ = 0;
};

}  // namespace

int main(int, char** argv) {
  Writer writer(argv[1]);
  for (int i = 1; i <= 8; ++i) {
    VirtualPull pull;
    pull.pavers = i % 2 == 0 ? 4 : 0;
    pull.drop_mass = (i % 4 < 2 ? 5.5 : 6.5) + 0.6 * pull.pavers;
    pull.resistance = writer.scattered(0.02);
    Trial trial = virtual_pull(pull);
    if (i > 6) trial.setup.use = TrialUse::kValidation;
    // Somebody wrote metres into the column of millimetres.
    writer.write("pull_" + std::to_string(i), trial, 10, i == 6 ? 1e-3 : 1);
  }
  VirtualPull pull;
  pull.heading = 90 * kRadiansPerDegree;
  pull.drop_mass = 8;
  for (int i = 1; i <= 2; ++i) {
    pull.resistance = writer.scattered(0.02);
    pull.patch_width = 0.008 * std::exp((i - 1.5) * 0.1);
    Trial trial = virtual_pull(pull);
    trial.kind = TrialKind::kCrosswisePull;
    writer.write("crosswise_" + std::to_string(i), trial, 7);
  }
  for (int i = 1; i <= 2; ++i) {
    const double share = std::exp((i - 1.5) * 0.05);
    VirtualWinch winch;
    winch.ramp = 40;
    winch.locked = LockedWheels::kFront;
    winch.static_friction = 0.62 * share;
    winch.kinetic_friction = 0.55 * share;
    writer.write("locked_" + std::to_string(i), virtual_winch(winch), 13);
    writer.write("impact_" + std::to_string(i), virtual_impact(0.3 + 0.1 * i, 0.4 * share), 3);
  }
}
