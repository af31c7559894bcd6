#pragma once

#include <optional>
#include <string>

#include "engine/scene/scene.h"
#include "equipment/catalogue/assumption.h"
#include "studies/job/job.h"
#include "studies/prepare/motion.h"
#include "studies/results/run_facts.h"

namespace gurney::study {

/// An assumption as results and summaries state it.
AssumptionFacts facts_of(const equipment::Assumption& assumption);

/// A job with its record read: run(facts.scene, facts.floor, facts.settings) runs it.
struct PreparedRun {
  RunFacts facts;
};

/// @param motion  of the floor; none: it rests
PreparedRun prepare_run(const Job& job, std::optional<Motion> motion);

/// Reads a job file and the record it asks for.
/// @throws Error with every error found in the job, its data files and its record.
PreparedRun prepare_run(const std::string& job_path);

}  // namespace gurney::study
