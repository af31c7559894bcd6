#include "engine/base/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <tuple>
#include <utility>

#include "engine/base/error.h"

namespace gurney {

void Diagnostics::add(int line, int column, const std::string& text) {
  keep({line, column, text, ""});
}

void Diagnostics::add_new(const std::string& lines, const std::string& remark) {
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);)
    if (std::ranges::find(entries_, line, &Entry::text) == entries_.end())
      keep({kUnplaced, 0, line, remark});
}

void Diagnostics::keep(Entry entry) {
  if (++count_ <= kept_) entries_.push_back(std::move(entry));
}

void Diagnostics::sort() {
  std::ranges::stable_sort(entries_, {},
                           [](const Entry& entry) { return std::tie(entry.line, entry.column); });
}

void Diagnostics::raise() const { raise(kAll, "", ""); }

void Diagnostics::raise(std::size_t most, const std::string& before,
                        const std::string& after) const {
  if (none()) return;
  const std::size_t shown = std::min(most, entries_.size());
  std::string lines;
  for (std::size_t i = 0; i < shown; ++i)
    lines += (i > 0 ? "\n" : "") + entries_[i].text + entries_[i].remark;
  if (count_ > shown) lines += fmt::format("\n{}{}{}", before, count_ - shown, after);
  throw Error(lines);
}

}  // namespace gurney
