#include "studies/run/shard.h"

#include <fmt/format.h>

#include <charconv>

#include "engine/base/error.h"

namespace gurney::study {
namespace {

using Environment = std::function<const char*(const char*)>;

std::optional<std::size_t> whole_number(std::string_view text) {
  std::size_t value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || problem != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

/// "3", "8" of "3/8" or "3-of-8".
std::optional<Shard> split(std::string_view text, std::string_view between) {
  const std::size_t at = text.find(between);
  if (at == std::string_view::npos) return {};
  const auto number = whole_number(text.substr(0, at));
  const auto count = whole_number(text.substr(at + between.size()));
  if (!number || !count || *number < 1 || *number > *count || *count > kMaxShards) return {};
  return Shard{*number, *count};
}

std::size_t value_of(const Environment& environment, const char* name, std::size_t missing) {
  const char* const text = environment(name);
  if (text == nullptr) return missing;
  const auto value = whole_number(text);
  require(value.has_value(),
          fmt::format("--shard auto: {} = '{}' must be a whole number", name, text));
  return *value;
}

/// @param zero_based  number from 0
Shard checked(const char* names, std::size_t zero_based, std::size_t count) {
  require(count >= 1 && count <= kMaxShards && zero_based < count,
          fmt::format("--shard auto: {} name shard {} of {}; 1 to {} shards are allowed", names,
                      zero_based + 1, count, kMaxShards));
  return {zero_based + 1, count};
}

Shard from_array(const Environment& environment) {
  const std::size_t id = value_of(environment, "SLURM_ARRAY_TASK_ID", 0);
  const std::size_t least = value_of(environment, "SLURM_ARRAY_TASK_MIN", 0);
  const std::size_t most = value_of(environment, "SLURM_ARRAY_TASK_MAX", 0);
  const std::size_t count = value_of(environment, "SLURM_ARRAY_TASK_COUNT", 0);
  // For --array=3,5 Slurm says two tasks from 3 to 5: the shards are not known.
  require(id >= least && most >= least && most - least + 1 == count,
          fmt::format("--shard auto: the array has {} tasks with indices from {} to {}, which are "
                      "not consecutive; give --shard \"$SLURM_ARRAY_TASK_ID/N\" with N shards",
                      count, least, most));
  return checked("SLURM_ARRAY_TASK_ID and SLURM_ARRAY_TASK_COUNT", id - least, count);
}

Shard from(const Environment& environment) {
  if (environment("SLURM_ARRAY_TASK_ID") != nullptr) return from_array(environment);
  if (environment("SLURM_PROCID") != nullptr)
    return checked("SLURM_PROCID and SLURM_NTASKS", value_of(environment, "SLURM_PROCID", 0),
                   value_of(environment, "SLURM_NTASKS", 0));
  if (environment("OMPI_COMM_WORLD_RANK") != nullptr)
    return checked("OMPI_COMM_WORLD_RANK and OMPI_COMM_WORLD_SIZE",
                   value_of(environment, "OMPI_COMM_WORLD_RANK", 0),
                   value_of(environment, "OMPI_COMM_WORLD_SIZE", 0));
  throw Error(
      "--shard auto: neither SLURM_ARRAY_TASK_ID nor SLURM_PROCID nor OMPI_COMM_WORLD_RANK is set; "
      "give --shard I/N");
}

}  // namespace

std::size_t Shard::tasks_of(std::size_t tasks) const {
  const std::size_t rows = tasks / count;  // each shard has one of every whole row
  std::size_t mine = rows;
  for (std::size_t task = rows * count; task < tasks; ++task) mine += has(task);
  return mine;
}

std::string Shard::folder() const { return fmt::format("{}-of-{}", number, count); }

std::string shard_problem(const std::string& text) {
  if (text == "auto" || split(text, "/")) return {};
  return fmt::format("{} must be I/N with 1 <= I <= N <= {}, or auto", text, kMaxShards);
}

Shard shard_from(const std::string& text, const Environment& environment) {
  const std::string problem = shard_problem(text);
  require(problem.empty(), "--shard: " + problem);
  return text == "auto" ? from(environment) : *split(text, "/");
}

std::optional<Shard> shard_of_folder(const std::string& name) { return split(name, "-of-"); }

}  // namespace gurney::study
