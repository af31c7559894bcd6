#pragma once

#include <optional>
#include <string>

#include "engine/response/response.h"
#include "groundmotions/record/record.h"
#include "studies/results/run_facts.h"

namespace gurney::bindings {

/// A run as `gurney run` has it before it writes the results file.
struct FinishedRun {
  study::RunFacts facts;
  Response response;
};

/// Job to run: a file, or its text.
struct RunRequest {
  std::string path;  ///< of the job; with a text: its name in messages
  std::optional<std::string> text;
  std::optional<groundmotions::Record> record;  ///< motion of the floor, where the job has none
  bool predictability = true;                   ///< runs the twin as well, as `gurney run` does
};

/// May be called from several threads at once.
/// @throws Error for what is wrong with the job, with its places
FinishedRun run_job(const RunRequest& request);

}  // namespace gurney::bindings
