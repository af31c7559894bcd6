#include "engine/base/random/draw.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/random/normal_draw.h"

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

}  // namespace

Draw Draw::of_part(const std::string& part) const {
  Draw draw = *this;
  draw.parts_ += part + '/';
  return draw;
}

std::string Draw::full_name(const std::string& variable) const { return parts_ + variable; }

double Draw::probability(const std::string& variable, const Group& group) const {
  const double own = uniform_draw(seed_, hash_of("variable " + full_name(variable)), run_);
  if (group.name.empty() || group.correlation == 0) return own;
  const double shared = uniform_draw(seed_, hash_of("group " + group.name), run_);
  const double r = group.correlation;
  if (r == 1) return shared;
  const double score =
      r * normal_quantile(shared) + std::sqrt(std::max(0.0, 1 - r * r)) * normal_quantile(own);
  return std::clamp(normal_cdf(score), 0x1p-54, 1 - 0x1p-53);
}

std::string Draw::text() const { return fmt::format("draw {} of seed {}", run_, seed_); }

}  // namespace gurney
