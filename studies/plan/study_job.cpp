#include "studies/plan/study_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "engine/base/append_all.h"
#include "engine/base/diagnostics.h"
#include "engine/base/error.h"
#include "engine/base/hash/sha256.h"
#include "engine/config/overlay.h"
#include "engine/config/table.h"
#include "equipment/catalogue/catalogue.h"
#include "studies/job/old_names.h"
#include "studies/limit_states/limit_state.h"
#include "studies/plan/study.h"

namespace gurney::study {
namespace {

using config::Node;

bool is_array_of_tables(const Node& node) {
  return node.kind == Node::Kind::kArray && !node.elements.empty() &&
         std::ranges::all_of(node.elements,
                             [](const Node& each) { return each.kind == Node::Kind::kTable; });
}

using config::Document;
using config::FileSnapshot;
using config::Node;

/// Level of each factor, for every combination; the last factor changes fastest.
std::vector<std::vector<std::size_t>> all_combinations(const Study& study) {
  std::vector<std::vector<std::size_t>> all{{}};
  for (const Factor& factor : study.factors) {
    std::vector<std::vector<std::size_t>> more;
    for (const std::vector<std::size_t>& base : all)
      for (std::size_t level = 0; level < std::max<std::size_t>(1, factor.levels.size()); ++level) {
        more.push_back(base);
        more.back().push_back(level);
      }
    all = std::move(more);
  }
  return all;
}

/// @param document  takes the errors
std::vector<Configuration> combined(const Node& job, const Study& study, Document& document) {
  std::vector<Configuration> all;
  for (const std::vector<std::size_t>& levels :
       study.combinations.empty() ? all_combinations(study) : study.combinations) {
    Configuration next{{}, job};
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const Factor& factor = study.factors[i];
      if (factor.levels.empty()) continue;  // an error that is noted
      const FactorLevel& level = factor.levels[levels[i]];
      next.levels.push_back(level.name);
      config::overlay(next.tree, level.patch, "study.factor." + factor.name, document);
    }
    all.push_back(std::move(next));
  }
  return all;
}

/// The reason why a study cannot have a suite of each level; empty: it can, or has none.
std::string wrong_with_suites(const RecordRequest& record, const Study& study) {
  if (!record.suite_by_level) return {};
  const IntensityPlan& plan = study.intensity;
  if (plan.kind != IntensityPlan::Kind::kStripes || plan.more_stages > 0)
    return "must go with study.intensity.levels that are not adaptive";
  if (study.sampling == Sampling::kSaltelli)
    return "must not go with study.sampling = \"saltelli\", where each record has each level";
  if (record.suite.size() == plan.levels.size()) return {};
  return fmt::format("must have a suite for each of the {} study.intensity.levels, has {}",
                     plan.levels.size(), record.suite.size());
}

/// Refuses keys of a single run that a study varies by itself.
/// @throws Error with each that is
void refuse_contradictions(const Document& document, const Job& job, const Study& study) {
  if (job.settings.peak_error > 0) {
    const Node* const settings = document.tree().find("settings");
    const Node* const stated = settings ? settings->find("peak_error") : nullptr;
    throw Error(document.where(stated ? stated->place : document.tree().place) +
                ": settings.peak_error: is for single runs; in a study, study.step_check compares "
                "runs with half the time step");
  }
  if (!job.record) {
    if (study.intensity.kind != IntensityPlan::Kind::kScales || study.angles.size() > 1)
      throw Error(document.where(document.tree().place) +
                  ": a study of intensities or angles needs [excitation.record]");
    return;
  }
  const RecordRequest& record = *job.record;
  Diagnostics errors;
  const auto refuse = [&](bool wrong, const std::string& message) {
    if (wrong) errors.add(record.where + ": " + message);
  };
  const bool is_scaled = study.intensity.kind != IntensityPlan::Kind::kScales;
  const auto where_of = [&](const char* key) {
    return document.where(document.tree().find("excitation")->find("record")->find(key)->place);
  };
  if (const std::string wrong = wrong_with_suites(record, study); !wrong.empty())
    errors.add(where_of("suite_by_level") + ": excitation.record.suite_by_level: " + wrong);
  refuse(record.scale_to && is_scaled,
         "scale_to must not go with study.intensity, which scales the records");
  if (record.scale != 1 && is_scaled)
    errors.add(fmt::format(
        "{}: excitation.record.scale = {:g}: has no effect with levels of a measure, to which "
        "study.intensity scales the records",
        where_of("scale"), record.scale));
  refuse(record.angle != 0 && study.angles.size() > 1,
         "angle_deg must not go with study.angles_deg");
  refuse(study.synthetic_records > 0 &&
             (!record.synthetic || !record.synthetic->values.contains("seed")),
         "study.synthetic_records needs a synthetic motion that has a seed");
  refuse(study.synthetic_records > 0 && record.synthetic &&
             record.synthetic->values.contains("seed") && record.synthetic->values.at("seed") != 1,
         "study.synthetic_records gives the seeds 1, 2, ...; leave the seed out");
  errors.raise();
}

/// Lines for keys of `[output]` that a study does not follow.
std::vector<std::string> output_without_effect(const Document& document, const Study& study) {
  const Node* const output = document.tree().find("output");
  const Node* const stated = output ? output->find("histories") : nullptr;
  if (stated == nullptr) return {};
  const std::string line = document.where(stated->place) + ": output.histories";
  if (study.keep.histories == Histories::kNone)
    return {line + ": has no effect in a study, which keeps those of study.keep.histories"};
  if (!stated->boolean)
    return {line + " = false: must not go with study.keep.histories, which asks for them"};
  return {};
}

/// Inputs that change nothing in a configuration; they are errors where none needs them.
class InputsWithoutEffect {
 public:
  void meet(const std::vector<std::string>& of_configuration) {
    for (const std::string& each : std::set(of_configuration.begin(), of_configuration.end()))
      ++count_[each];
  }
  std::vector<std::string> everywhere(std::size_t configurations) const {
    std::vector<std::string> lines;
    for (const auto& [line, count] : count_)
      if (count == configurations) lines.push_back(line);
    return lines;
  }

 private:
  std::map<std::string, std::size_t> count_;
};

template <class Work>
void collect(Diagnostics& errors, Work work) {
  try {
    work();
  } catch (const Error& error) {
    errors.add_new(error.what());
  }
}

namespace fs = std::filesystem;

std::string name_of(const fs::path& path, const fs::path& beside) {
  const fs::path data = fs::absolute(equipment::data_folder()).lexically_normal();
  const fs::path in_catalogue = path.lexically_relative(data);
  const std::string from = in_catalogue.string();
  if (from.starts_with("equipment/") || from.starts_with("groundmotions/buildings/")) return from;
  return path.lexically_proximate(beside).string();
}

}  // namespace

void flatten(const Node& node, const std::string& path,
             std::map<std::string, std::string>& entries) {
  if (node.kind == Node::Kind::kTable) {
    for (const Node& each : node.elements)
      flatten(each, path.empty() ? each.key : path + "." + each.key, entries);
  } else if (is_array_of_tables(node)) {
    for (std::size_t i = 0; i < node.elements.size(); ++i) {
      const Node* name = node.elements[i].find("name");
      flatten(node.elements[i],
              fmt::format("{}[{}]", path, name ? name->text : std::to_string(i + 1)), entries);
    }
  } else {
    entries[path] = config::describe(node);
  }
}

void StudyJob::check_limit_states(const Node& study, const Job& job) const {
  const Node* const stated = study.find("limit_state");
  if (stated == nullptr) return;
  const Places places = places_of(job.scene);
  for (std::size_t i = 0; i < study_.limit_states.size(); ++i) {
    try {
      check_names(study_.limit_states[i], places, "the job");
    } catch (const Error& error) {
      throw Error(fmt::format("{}: study.limit_state[{}]: {}",
                              document_->where(stated->elements.at(i).place), i, error.what()));
    }
  }
}

StudyJob::StudyJob(const std::string& path)
    : StudyJob(std::make_unique<FileSnapshot>(), std::make_unique<Document>(path)) {}

StudyJob::StudyJob(const std::string& text, const std::string& path)
    : StudyJob(std::make_unique<FileSnapshot>(), std::make_unique<Document>(text, path)) {}

StudyJob::StudyJob(std::unique_ptr<FileSnapshot> files, std::unique_ptr<Document> document)
    : files_(std::move(files)), document_(std::move(document)) {
  notes_ = rename_old_keys(*document_);
  Diagnostics errors;  // of all configurations, each line once
  auto taken = document_->take("study");
  require(taken.has_value(), file() + ": the job has no table [study]");
  Node whole;
  whole.elements.push_back(*taken);
  Document reading(whole, *document_);
  bool clean = false;
  collect(errors, [&] {
    config::Table root = reading.root();
    if (auto table = root.table("study"))
      study_ = read_study(*table, *reading.tree().find("study"));
    else
      root.set_aside("study");
    if (const auto uncertainty = document_->take("uncertainty"))
      reading.note(uncertainty->key_place,
                   "uncertainty: must not go with [study], which has draws and a seed of its own");
    configurations_ = combined(document_->tree(), study_, reading);
    clean = reading.clean();
    reading.finish();
  });
  InputsWithoutEffect without_effect;
  for (std::size_t i = 0; i < configurations_.size(); ++i)
    collect(errors, [&] {
      const FileSnapshot::Scope scope(*files_);
      Document tree(configurations_[i].tree, *document_);
      const Job& each = models_.emplace_back(tree).stated();
      std::vector<std::string> idle = output_without_effect(tree, study_);
      append_all(idle, each.without_effect);
      without_effect.meet(idle);
      if (!clean) return;
      refuse_contradictions(tree, each, study_);
      check_limit_states(*taken, each);
    });
  for (const std::string& line : without_effect.everywhere(configurations_.size()))
    errors.add_new(line);
  errors.raise();
  if (study_.draws > 0 && !draws_anything())
    throw Error(document_->where(taken->find("draws")->place) +
                ": study.draws: has no effect: no parameter of the job has a distribution");
}

bool StudyJob::draws_anything() const {
  try {
    for (std::size_t i = 0; i < configurations_.size(); ++i)
      if (study::draws_anything(job(i, Draw(study_.seed, 0)))) return true;
    return false;
  } catch (const Error&) {  // the job without a draw is right, so this draw changed it
    return true;
  }
}

Job StudyJob::job(std::size_t configuration, const std::optional<Draw>& draw,
                  std::size_t replica) const {
  return sample(models_.at(configuration), draw, replica);
}

bool has_study(const std::string& path) { return Document(path).tree().find("study") != nullptr; }

std::map<std::string, std::string> data_files(const StudyJob& job) {
  const fs::path file = fs::absolute(job.file()).lexically_normal();
  std::map<std::string, std::string> hashes;
  for (const auto& [path, bytes] : job.files().files())
    if (path != file) hashes[name_of(path, file.parent_path())] = sha256(bytes);
  return hashes;
}

}  // namespace gurney::study
