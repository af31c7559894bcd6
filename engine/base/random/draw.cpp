#include "engine/base/random/draw.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "engine/base/random/group_strata.h"
#include "engine/base/random/normal_draw.h"
#include "engine/base/random/sampling.h"

namespace gurney {
namespace {

/// FNV-1a, 64 bits (Fowler, Noll & Vo; IETF draft-eastlake-fnv).
std::uint64_t hash_of(const std::string& name) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : name) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3;
  }
  return hash;
}

std::string group_stream(const CorrelationGroup& group) { return "group " + group.name; }

}  // namespace

Draw Draw::of_part(const std::string& part) const {
  Draw draw = *this;
  draw.parts_ += part + '/';
  return draw;
}

std::string Draw::own_stream(const std::string& variable) const {
  return "variable " + full_name(variable);
}

std::string Draw::full_name(const std::string& variable) const { return parts_ + variable; }

Draw Draw::of_hypercube(std::uint64_t seed, std::uint64_t run, std::uint64_t size) {
  Draw draw(seed, run);
  draw.cells_ = size;
  return draw;
}

Draw Draw::of_sobol(std::uint64_t seed, std::uint64_t run, std::shared_ptr<const Streams> streams) {
  Draw draw(seed, run);
  draw.streams_ = std::move(streams);
  return draw;
}

Draw Draw::of_saltelli(std::uint64_t seed, std::uint64_t run, const SaltelliRow& row,
                       std::shared_ptr<const Streams> inputs) {
  Draw draw = of_sobol(seed, run, std::move(inputs));
  draw.row_ = row;
  return draw;
}

double Draw::uniform(const std::string& stream) const {
  if (streams_) {
    const auto found = streams_->find(stream);
    if (found != streams_->end()) {
      const auto ordinal = static_cast<std::uint64_t>(std::distance(streams_->begin(), found));
      return row_ ? saltelli_draw(seed_, streams_->size(), ordinal, *row_)
                  : sobol_draw(seed_, ordinal, run_);
    }
  }
  if (row_) return uniform_draw(seed_, hash_of(stream), 2 * row_->point + (row_->matrix == 1));
  const std::uint64_t key = hash_of(stream);
  if (cells_ > 0) return latin_hypercube_draw(seed_, key, run_, cells_);
  return uniform_draw(seed_, key, run_);
}

Draw::Streams Draw::streams_of(const std::string& variable, const CorrelationGroup& group) const {
  const double r = group.name.empty() ? 0 : group.correlation;
  Streams streams;
  if (r != 0) streams.insert(group_stream(group));
  if (r != 1) streams.insert(own_stream(variable));
  return streams;
}

double Draw::probability(const std::string& variable, const CorrelationGroup& group) const {
  const double r = group.name.empty() ? 0 : group.correlation;
  if (r == 1) return uniform(group_stream(group));
  const double own = uniform(own_stream(variable));
  if (r == 0) return own;
  if (cells_ > 0 && std::abs(r) < 1)
    return stratified_member(
        {seed_, cells_, hash_of(group_stream(group)), hash_of(own_stream(variable)), r}, run_);
  const double score = member_score(r, uniform(group_stream(group)), own);
  return std::clamp(normal_cdf(score), 0x1p-54, 1 - 0x1p-53);
}

std::string Draw::text() const { return fmt::format("draw {} of seed {}", run_, seed_); }

}  // namespace gurney
