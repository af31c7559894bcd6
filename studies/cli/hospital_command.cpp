#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <set>

#include "engine/base/error.h"
#include "engine/base/files.h"
#include "engine/base/input_file.h"
#include "engine/base/parallel.h"
#include "engine/base/shell_word.h"
#include "studies/cli/commands.h"
#include "studies/cli/output.h"
#include "studies/cli/run_command.h"
#include "studies/cli/shared_options.h"
#include "studies/figures/hospital_figure.h"
#include "studies/hospital/hospital_answer.h"
#include "studies/plan/study_job.h"
#include "studies/plan/study_motions.h"
#include "studies/report/hospital_report.h"
#include "studies/results/output_files.h"
#include "studies/results/study_reader.h"
#include "studies/run/study_identity.h"

namespace gurney::cli {
namespace {

struct HospitalOptions {
  std::string file, job, run;
  study::HospitalRequest request;
  FigureFile figure;
  bool json = false;
};

/// Writes the hospital's job beside the results and runs it; what is there already is not run again.
int run_hospital(const HospitalOptions& options, const std::string& job) {
  const std::filesystem::path path = std::filesystem::path(options.run).replace_extension(".toml");
  if (!is_there(path) || read_input_file(path.string()) != job)
    write_output(path.string(), job, options.figure.overwrite, true);
  RunOptions run;
  run.job = path.string();
  run.output = options.run;
  run.quiet = run.json = options.json;
  run.quiet = true;
  run.resume = is_there(options.run) || is_there(options.run + ".parts");
  run.overwrite = options.figure.overwrite;
  run.threads = options.request.threads;
  return run_study(run);
}

/// Data files that are in both and differ, by their names: a study may have been run elsewhere.
std::string changed_files(const study::StudyReader& file, const study::StudyJob& job) {
  const study::StudyMotions motions(job);  // which read buildings
  std::map<std::string, std::string> now;
  for (const auto& [name, hash] : data_files(job))
    now[std::filesystem::path(name).filename().string()] = hash;
  const auto names = file.strings("data_files/name"), hashes = file.strings("data_files/sha256");
  std::set<std::string> changed;
  for (std::size_t row = 0; row < names.size(); ++row) {
    const auto found = now.find(std::filesystem::path(names[row]).filename().string());
    if (found != now.end() && found->second != hashes[row]) changed.insert(found->first);
  }
  return changed.empty() ? "" : fmt::format("changed since: {}", fmt::join(changed, ", "));
}

/// Refuses results whose runs are of another building, record, covering or item than the hospital's.
void check_results(const std::string& path, const study::Hospital& hospital,
                   const study::Consequences& consequences) {
  if (!hospital.study) return;  // nothing says of which study they should be
  const study::StudyReader file(path);
  const std::string job = study_job(hospital, consequences);
  std::string differs = study::run_difference(file.job_text(), job);
  if (differs.empty()) differs = changed_files(file, study::StudyJob(job, hospital.path));
  require(differs.empty(),
          fmt::format("{}: is not of the study that {} becomes: {}", path, hospital.path, differs));
}

int hospital(const HospitalOptions& options) {
  options.figure.check();
  const study::Hospital hospital = study::read_hospital(options.file);
  const auto consequences = study::Consequences::read(hospital.consequences);
  if (!options.job.empty()) {
    const std::string job = study_job(hospital, consequences);
    study::StudyJob(job, options.job);  // nothing that could not be run
    write_output(options.job, job, options.figure.overwrite, options.json);
    return 0;
  }
  study::HospitalRequest request = options.request;
  request.threads = threads_or_all(request.threads);
  int code = 0;
  if (!options.run.empty()) {
    code = run_hospital(options, study_job(hospital, consequences));
    if (code != 0 && code != 3) return code;
    request.results = options.run;
  }
  if (!request.results.empty()) check_results(request.results, hospital, consequences);
  const study::HospitalAnswer answer = hospital_answer(hospital, consequences, request);
  options.figure.write([&] { return figures::hospital_figure(hospital, answer); }, true);
  print_findings(report::hospital_findings(hospital, answer), options.json);
  return code;
}

}  // namespace

void add_hospital(Commands& commands) {
  commands.add<HospitalOptions>(
      {"hospital", "Services, beds and loss of a hospital; what to secure first",
       "gurney hospital ward.toml\n"
       "gurney hospital ward.toml --run out/ward.h5 --figure ward.svg\n"
       "gurney hospital ward.toml --by \"intensive care\" --at 0.4"},
      hospital, [](Options& add, HospitalOptions& options) {
        add.required("FILE", options.file, "The hospital: rooms, items, services, actions");
        CLI::Option* const job =
            add("--job FILE", options.job, "Write the study that it becomes, for gurney run");
        CLI::Option* const run =
            add("--run RESULTS", options.run,
                "Run that study, or go on with it, into this .h5 file, and answer from its runs");
        add("--results FILE", options.request.results,
            "Answer from the runs of that study (default: from curves)")
            ->excludes(job)
            ->excludes(run);
        job->excludes(run);
        add("--at NUMBER", options.request.at,
            "PGV in m/s at which actions are ranked, a level of the file (default: the middle "
            "one)");
        add("--by WHAT", options.request.by,
            "Rank actions by beds, loss or a service (default: beds, or loss without beds)");
        add("--samples", options.request.samples, "Samples of the motion (default: 10000)")
            ->check(CLI::Range(std::size_t{100}, std::size_t{10000000}));
        add("--seed", options.request.seed, "Seed of the samples (default: 1)");
        add_figure_option(add, options.figure, "Draw services, beds and ranking", "--figure FILE",
                          "files that exist");
        add.threads(options.request.threads, "Threads (default: all cores)");
        add("--json", options.json, "Print JSON");
      });
}

}  // namespace gurney::cli
