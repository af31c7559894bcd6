#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace gurney::study {

/// One of the shares into which the analysis cases of a study are divided, for as many processes.
/// Each shard has one of `count` cases that follow each other, and every next time another one, so
/// that no shard has all cases of a long record or of one configuration.
struct Shard {
  std::size_t number = 1;  ///< from 1
  std::size_t count = 1;

  bool has(std::size_t task) const { return (task + task / count) % count + 1 == number; }
  /// Number of its tasks among those of a study.
  std::size_t tasks_of(std::size_t tasks) const;

  /// Name of its folder: "3-of-8".
  std::string folder() const;

  friend bool operator==(const Shard&, const Shard&) = default;
};

inline constexpr std::size_t kMaxShards = 100000;

/// The fault of a shard that is neither "3/8" nor "auto"; empty: none.
std::string shard_problem(const std::string& text);

/// Reads "3/8", or "auto" from the variables of Slurm (of an array, else of a step) or Open MPI.
/// @param environment  as std::getenv
/// @throws Error with what is allowed
Shard shard_from(const std::string& text,
                 const std::function<const char*(const char*)>& environment);

/// The shard whose folder has this name; none: it is not one of a shard.
std::optional<Shard> shard_of_folder(const std::string& name);

}  // namespace gurney::study
