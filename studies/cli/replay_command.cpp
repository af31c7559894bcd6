#include "studies/cli/replay_command.h"

#include <fmt/format.h>

#include <filesystem>

#include "engine/base/error.h"
#include "studies/analysis/replica_spread.h"
#include "studies/cli/run_output.h"
#include "studies/cli/standard_error.h"
#include "studies/cli/study_case.h"
#include "studies/results/study_reader.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;

std::string spread_text(const std::optional<study::ReplicaSpread>& spread,
                        const study::UnitSystem& units) {
  if (!spread) return {};
  const study::ReportUnit unit = units.of("m");
  const std::string range = fmt::format("{:.3g} to {:.3g} {}", spread->lowest / unit.in_si,
                                        spread->highest / unit.in_si, unit.name);
  return fmt::format(
      "replicas {} of this case: peak displacement {}, median {}; {} "
      "overturned, {} failed\n",
      spread->runs, range, units.text(spread->median, "m"), spread->overturned, spread->failed);
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
  const RunOutput output{results_of(options),
                         study_case.job(),
                         options.overwrite,
                         options.json,
                         options.no_figure,
                         options.figures,
                         false,
                         options.units,
                         true};
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
               spread_text(study::replica_spread(file, options.run), options.units));
  return is_failure(response.outcome) ? 3 : 0;
}

}  // namespace gurney::cli
