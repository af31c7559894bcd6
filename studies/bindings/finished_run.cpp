#include "studies/bindings/finished_run.h"

#include "engine/base/error.h"
#include "engine/config/table.h"
#include "engine/run/run.h"
#include "studies/job/job.h"
#include "studies/prepare/run_job.h"

namespace gurney::bindings {
namespace {

study::Job job_of(const RunRequest& request) {
  std::optional<config::Document> document;
  if (request.text)
    document.emplace(*request.text, request.path);
  else
    document.emplace(request.path);
  require(!document->root().has("study"),
          request.path + ": has a table [study]: many runs, which `gurney run` makes; here is one");
  return study::read_job(*document);
}

/// The record in memory has nothing to be read, so the request is that of a bare file.
study::Motion motion_of_array(const groundmotions::Record& record) {
  study::RecordRequest request;
  request.where = "record";
  request.use_y = record[groundmotions::Direction::kH2].has_value();
  request.use_z = record[groundmotions::Direction::kVertical].has_value();
  return study::motion_of(record, request);
}

std::optional<study::Motion> motion(const study::Job& job, const RunRequest& request) {
  if (!request.record) return study::motion_of(job);
  require(!job.record, request.path + ": has a record already; leave out the array, or the table");
  return motion_of_array(*request.record);
}

}  // namespace

FinishedRun run_job(const RunRequest& request) {
  const study::Job job = job_of(request);
  FinishedRun run{study::prepare_run(job, motion(job, request)).facts, {}};
  const study::RunFacts& facts = run.facts;
  run.response = request.predictability
                     ? run_judged(facts.scene, facts.floor, facts.settings, 1).response
                     : gurney::run(facts.scene, facts.floor, facts.settings);
  return run;
}

}  // namespace gurney::bindings
