#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "engine/base/random/sampling.h"

namespace gurney {

/// Correlation of a variable with a group: the variables of a group share one normal variable.
struct CorrelationGroup {
  std::string name;        ///< empty: the variable is independent of all others
  double correlation = 1;  ///< of its normal score with the group's variable, in [-1, 1]
};

/// One realisation of everything that is uncertain: run `run` of the study with seed `seed`.
///
/// A variable is known by its name. Its probability rests on (seed, run, name) alone, so that no
/// other variable, no order and no number of threads change it.
class Draw {
 public:
  Draw(std::uint64_t seed, std::uint64_t run) : seed_(seed), run_(run) {}

  /// Draw `run` of a Latin hypercube of `size` draws.
  /// @param run  below `size`
  static Draw of_hypercube(std::uint64_t seed, std::uint64_t run, std::uint64_t size);

  /// The streams that draws ask for: `variable mass_kg` and `group treads`.
  using Streams = std::set<std::string>;

  /// Point `run` of a Sobol sequence, whose dimensions are the streams in their order. A stream
  /// that is not among them is drawn by itself.
  static Draw of_sobol(std::uint64_t seed, std::uint64_t run,
                       std::shared_ptr<const Streams> streams);

  /// Draw `run`, a row of a Saltelli design whose inputs are the streams in their order. A stream
  /// that is not among them is one of A's in all rows but those of B.
  static Draw of_saltelli(std::uint64_t seed, std::uint64_t run, const SaltelliRow& row,
                          std::shared_ptr<const Streams> inputs);

  /// This draw for a part: names of variables begin with `part/`, groups keep theirs.
  Draw of_part(const std::string& part) const;

  std::string full_name(const std::string& variable) const;  ///< with the parts before it

  /// The probability, in (0, 1), at which the variable's quantile function is to be taken.
  ///
  /// It is u, uniform, of a Latin hypercube or of a Sobol sequence, where the variable is
  /// independent; else Phi(r z_group + sqrt(1 - r^2) z) with
  /// z = Phi^-1(u), z_group alone where r is 1, r the correlation: a Gaussian copula
  /// (docs/theory/uncertainty.md). In a Latin hypercube the score is put into the cell of its rank
  /// among all draws: stratified_member().
  double probability(const std::string& variable, const CorrelationGroup& group = {}) const;

  /// The streams that probability() takes for this variable.
  Streams streams_of(const std::string& variable, const CorrelationGroup& group = {}) const;

  std::uint64_t seed() const { return seed_; }
  std::uint64_t run() const { return run_; }
  std::string text() const;  ///< `draw 3 of seed 1`

 private:
  std::string own_stream(const std::string& variable) const;
  double uniform(const std::string& stream) const;

  std::uint64_t seed_, run_;
  std::uint64_t cells_ = 0;                 ///< of a Latin hypercube; 0: none
  std::shared_ptr<const Streams> streams_;  ///< of a Sobol sequence or a Saltelli design
  std::optional<SaltelliRow> row_;
  std::string parts_;
};

}  // namespace gurney
