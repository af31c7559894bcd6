#include "studies/calibration/pulling/trials.h"

#include <fmt/format.h>

#include <filesystem>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "studies/calibration/pulling/simulated_trial.h"
#include "studies/calibration/pulling/trial_job.h"
#include "studies/calibration/trials/instrument_noise.h"
#include "studies/calibration/trials/trial_file.h"

namespace gurney::calibration {

void export_trials(const std::string& path, const std::optional<std::uint64_t>& noise,
                   const study::TakeFile& take) {
  const study::StudyReader file(path);
  const std::string noisy =
      noise ? fmt::format("; synthetic noise of {:g} mm and {:g} N, seed {}",
                          kMillimetersPerMeter * kDisplacementNoise, kForceNoise, *noise)
            : "";
  for (const SimulatedTrial& each : simulated_trials(file, noise))
    take(each.trial.name + ".csv",
         trial_file_text(each.trial,
                         fmt::format("SYNTHETIC: run {} of job {} by gurney {}, not a measurement; "
                                     "{}; f_r of the input: {:.4f} N{}",
                                     each.run, file.text_attribute("job_name"),
                                     file.text_attribute("program_version"), each.configuration,
                                     each.theory.resistance, noisy)));
}

std::vector<std::string> export_trial_job(const std::string& path, const study::TakeFile& take) {
  const std::string name = (std::filesystem::path(path) / "").parent_path().stem().string();
  const TrialJob job = job_of_trials(measured_trials(path), name);
  std::string reasons;
  for (const std::string& each : job.left_out) reasons += "\n" + each;
  require(!job.text.empty(), path + ": no pull that can be repeated under its force" + reasons);
  take(study::plain_identifier(name, "trials") + ".toml", job.text);
  return job.left_out;
}

}  // namespace gurney::calibration
