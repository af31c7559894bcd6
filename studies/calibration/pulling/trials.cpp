#include "studies/calibration/pulling/trials.h"

#include <fmt/format.h>

#include "studies/calibration/pulling/simulated_trial.h"
#include "studies/calibration/trials/trial_file.h"

namespace gurney::calibration {

void export_trials(const std::string& path, const study::TakeFile& take) {
  const study::StudyReader file(path);
  for (const SimulatedTrial& each : simulated_trials(file))
    take(each.trial.name + ".csv",
         trial_file_text(each.trial,
                         fmt::format("SYNTHETIC: run {} of job {} by gurney {}, not a measurement; "
                                     "{}; f_r of the input: {:.4f} N",
                                     each.run, file.text_attribute("job_name"),
                                     file.text_attribute("program_version"), each.configuration,
                                     each.theory.resistance)));
}

}  // namespace gurney::calibration
