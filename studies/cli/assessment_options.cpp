#include "studies/cli/assessment_options.h"

namespace gurney::cli {

void add_limit_state_options(CLI::App& command, study::AssessmentRequest& request) {
  command
      .add_option("--limit-state", request.limit_states,
                  "A limit state instead of those of the job, such as 'peak_displacement > 0.2 m' "
                  "or 'NAME = overturned'; repeatable")
      ->allow_extra_args(false);
  command.add_option("--limit-states", request.limit_states_file,
                     "File of limit states and performance levels instead of those of the job");
}

CLI::Option* add_hazard_option(CLI::App& command, study::AssessmentRequest& request) {
  return command.add_option("--hazard", request.hazard_file,
                            "File of the site's hazard curve instead of that of the job");
}

}  // namespace gurney::cli
