#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace gurney::study {

/// What a service needs, as a file states it: `all(bed, any(ventilator, "spare ventilator"))`,
/// `at_least(3, pole, pump)`, `not_reached(bed, "moved 1 m")`, or a name alone.
struct Requirement {
  enum class Kind { kName, kAll, kAny, kAtLeast, kNotReached };
  Kind kind = Kind::kName;
  std::string name;   ///< of kName and kNotReached
  std::string state;  ///< of kNotReached
  int at_least = 0;   ///< of kAtLeast, >= 1
  std::vector<Requirement> parts;
  std::size_t column = 1;  ///< where it begins in the text, from 1
};

/// A name with other characters than letters, digits and `_ - . /` stands in double quotes.
/// @throws Error `at character 5: ...`
Requirement read_requirement(const std::string& text);

/// States that a piece has reached, a bit for each.
using Reached = std::uint32_t;
inline constexpr std::size_t kMostStates = 32;

/// Success tree over the pieces of a hospital (Vesely, Goldberg, Roberts & Haasl 1981, Fault Tree
/// Handbook, NUREG-0492, with works in place of fails: a coherent structure function).
class FaultTree {
 public:
  using Node = std::size_t;

  /// @param lost  states of which the piece may have reached none
  Node piece(std::size_t piece, Reached lost);

  /// Works when `at_least` of its parts do: 1 any, all of them all.
  /// @throws Error unless 1 <= at_least <= parts
  Node gate(int at_least, std::vector<Node> parts);

  /// Whether each node works.
  /// @param reached  by each piece
  /// @param works    room for size() values
  void evaluate(const Reached* reached, std::vector<char>& works) const;

  std::size_t size() const { return nodes_.size(); }

 private:
  struct Part {
    int at_least = 0;  ///< 0: a piece
    std::size_t piece = 0;
    Reached lost = 0;
    std::vector<Node> parts;  ///< each before this
  };
  std::vector<Part> nodes_;
};

}  // namespace gurney::study
