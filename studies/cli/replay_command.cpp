#include "studies/cli/replay_command.h"

#include <fmt/format.h>

#include <filesystem>

#include "engine/base/error.h"
#include "studies/cli/run_output.h"
#include "studies/cli/standard_error.h"
#include "studies/cli/study_case.h"
#include "studies/study/analysis/replica_spread.h"
#include "studies/study/results/study_reader.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;

std::string spread_text(const std::optional<study::ReplicaSpread>& spread) {
  if (!spread) return {};
  return fmt::format(
      "replicas {} of this case: peak displacement {:.3g} to {:.3g} m, median {:.3g} m; {} "
      "overturned, {} failed\n",
      spread->runs, spread->lowest, spread->highest, spread->median, spread->overturned,
      spread->failed);
}

fs::path results_of(const ReplayOptions& options) {
  if (!options.output.empty()) {
    require(fs::path(options.output).extension() == ".h5",
            options.output + ": the results file must end in .h5 (-o FILE.h5)");
    return options.output;
  }
  const fs::path file = options.file;
  return file.parent_path() / fmt::format("{}_run_{}.h5", file.stem().string(), options.run);
}

}  // namespace

int replay_command(const ReplayOptions& options) {
  options.figures.check();
  const StudyCase study_case(options.file, options.run, options.job);
  const RunOutput output{results_of(options), study_case.job(),  options.overwrite,
                         options.json,        options.no_figure, options.figures};
  check_output(output);
  const Response response = run_and_write(study_case.prepared(), output);
  const std::string differs = study_case.difference(response);
  if (!differs.empty()) {
    print_error("{}\n", differs);
    return 1;
  }
  const study::StudyReader file(options.file);
  if (!options.json)
    fmt::print("replay   the same results as in {}\n{}", options.file,
               spread_text(study::replica_spread(file, options.run)));
  return is_failure(response.outcome) ? 3 : 0;
}

}  // namespace gurney::cli
