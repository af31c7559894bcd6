#include "engine/config/toml_depth.h"

#include <algorithm>
#include <vector>

namespace gurney::config {
namespace {

class Scanner {
 public:
  explicit Scanner(const std::string& text) : text_(text) {}

  std::optional<std::size_t> too_deep() {
    for (at_ = 0; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '"' || c == '\'')
        skip_string(c);
      else if (c == '#')
        at_ = std::min(text_.find('\n', at_), text_.size()) - 1;
      else
        take(c);
      if (depth_ > kDeepestNesting) return at_;
    }
    return {};
  }

 private:
  /// Each open bracket, and each dot of the key that is being read in it, is a level.
  void take(char c) {
    if (c == '[' || c == '{') {
      open_.push_back(0);
      ++depth_;
    } else if ((c == ']' || c == '}') && open_.size() > 1) {
      depth_ -= 1 + open_.back();
      open_.pop_back();
    } else if (c == '.') {
      ++open_.back();
      ++depth_;
    } else if (c == ',' || c == '\n') {
      depth_ -= open_.back();
      open_.back() = 0;
    }
  }

  void skip_string(char quote) {
    const std::string three(3, quote);
    const bool multi_line = text_.compare(at_, 3, three) == 0;
    const std::string end = multi_line ? three : std::string(1, quote);
    at_ += end.size();
    while (at_ < text_.size() && text_.compare(at_, end.size(), end) != 0) {
      if (!multi_line && text_[at_] == '\n') return;  // no TOML; the parser says so
      at_ += quote == '"' && text_[at_] == '\\' ? 2 : 1;
    }
    at_ += end.size() - 1;
  }

  const std::string& text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::vector<int> open_{0};  ///< dots of the key in each open bracket
};

}  // namespace

std::optional<Place> find_too_deep(const std::string& text) {
  const std::optional<std::size_t> at = Scanner(text).too_deep();
  if (!at) return {};
  Place place;
  for (std::size_t i = 0; i < *at; ++i) {
    place.column = text[i] == '\n' ? 1 : place.column + 1;
    place.line += text[i] == '\n';
  }
  return place;
}

}  // namespace gurney::config
