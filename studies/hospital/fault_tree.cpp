#include "studies/hospital/fault_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/base/error.h"
#include "engine/base/number_text.h"
#include "engine/config/nearest_name.h"

namespace gurney::study {
namespace {

constexpr int kDeepest = 64;

/// Recursive descent over: requirement = name | name "(" argument { "," argument } ")".
class Parser {
 public:
  explicit Parser(const std::string& text) : text_(text) {}

  Requirement whole() {
    Requirement read = requirement(0);
    skip_blanks();
    if (at_ < text_.size()) fail("nothing may follow here", at_);
    return read;
  }

 private:
  [[noreturn]] void fail(const std::string& message, std::size_t at) const {
    throw Error(fmt::format("at character {}: {}", at + 1, message));
  }

  void skip_blanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
  }

  bool takes(char c) {
    skip_blanks();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  void need(char c) {
    if (!takes(c)) fail(fmt::format("'{}' must stand here", c), at_);
  }

  static bool is_plain(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) ||
           std::string_view("_-./").find(c) != std::string_view::npos ||
           static_cast<unsigned char>(c) > 127;
  }

  std::string name() {
    skip_blanks();
    const std::size_t begin = at_;
    std::string read;
    if (takes('"')) {
      while (at_ < text_.size() && text_[at_] != '"') read += text_[at_++];
      if (at_ == text_.size()) fail("a quote that does not end", begin);
      ++at_;
    } else {
      while (at_ < text_.size() && is_plain(text_[at_])) read += text_[at_++];
    }
    if (read.empty()) fail("a name must stand here", begin);
    return read;
  }

  int count() {
    const std::size_t begin = at_;
    const std::string text = name();
    const std::optional<double> value = number(text);
    if (!value || !(*value >= 1 && *value <= std::numeric_limits<int>::max()) ||
        *value != std::floor(*value))
      fail(fmt::format("'{}': at_least begins with a whole number from 1 on", text), begin);
    return static_cast<int>(*value);
  }

  Requirement requirement(int depth) {
    if (depth > kDeepest) fail(fmt::format("nested deeper than {}", kDeepest), at_);
    skip_blanks();
    Requirement read;
    const std::size_t begin = at_;
    read.column = begin + 1;
    read.name = name();
    if (!takes('(')) return read;
    using Kind = Requirement::Kind;
    static const std::vector<std::string> kGates = {"all", "any", "at_least", "not_reached"};
    const auto gate = std::find(kGates.begin(), kGates.end(), read.name);
    if (gate == kGates.end())
      fail(fmt::format("'{}(': is no gate{}", read.name, config::suggestion(read.name, kGates)),
           begin);
    read.kind = static_cast<Kind>(1 + (gate - kGates.begin()));
    if (read.kind == Kind::kNotReached) {
      read.name = name();
      need(',');
      read.state = name();
      need(')');
      return read;
    }
    if (read.kind == Kind::kAtLeast) {
      read.at_least = count();
      need(',');
    }
    do read.parts.push_back(requirement(depth + 1));
    while (takes(','));
    need(')');
    return read;
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

}  // namespace

Requirement read_requirement(const std::string& text) { return Parser(text).whole(); }

FaultTree::Node FaultTree::piece(std::size_t piece, Reached lost) {
  nodes_.push_back({0, piece, lost, {}});
  return nodes_.size() - 1;
}

FaultTree::Node FaultTree::gate(int at_least, std::vector<Node> parts) {
  require(at_least >= 1 && static_cast<std::size_t>(at_least) <= parts.size(),
          fmt::format("at_least {} of {}: must be 1 to {}", at_least, parts.size(), parts.size()));
  nodes_.push_back({at_least, 0, 0, std::move(parts)});
  return nodes_.size() - 1;
}

void FaultTree::evaluate(const Reached* reached, std::vector<char>& works) const {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Part& node = nodes_[i];
    if (node.at_least == 0) {
      works[i] = (reached[node.piece] & node.lost) == 0;
      continue;
    }
    int working = 0;
    for (const Node part : node.parts) working += works[part];
    works[i] = working >= node.at_least;
  }
}

}  // namespace gurney::study
