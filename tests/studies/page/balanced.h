#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace gurney::page {

/// What is wrong with the tags of a page: one that is closed without being open, or the other way
/// round, an attribute without quotes, an id that occurs twice, a `<` that begins no tag. Empty:
/// nothing.
inline std::string unbalanced(std::string_view page) {
  const std::set<std::string> alone{"meta", "link", "input", "br", "!DOCTYPE"};
  std::vector<std::string> open;
  std::set<std::string> ids;
  for (std::size_t at = page.find('<'); at != page.npos; at = page.find('<', at)) {
    std::size_t end = at + 1;
    for (char quote = 0; end < page.size() && (quote != 0 || page[end] != '>'); ++end)
      if (page[end] == '"') quote = quote == 0 ? '"' : char(0);
    const std::string tag(page.substr(at + 1, end - at - 1));
    const std::string name = tag.substr(0, tag.find_first_of(" \n/", 1));
    if (name.empty() || name.find('<') != name.npos) return "no tag: <" + tag.substr(0, 40);
    at = end;
    if (tag.starts_with('/')) {
      if (open.empty() || "/" + open.back() != name)
        return "<" + name + "> closes " + (open.empty() ? "nothing" : open.back());
      open.pop_back();
      continue;
    }
    for (std::size_t sign = tag.find('='); sign != tag.npos; sign = tag.find('=', sign)) {
      if (tag[++sign] != '"') return "no quotes: <" + tag;
      const std::size_t close = tag.find('"', sign + 1);
      const std::string value = tag.substr(sign + 1, close - sign - 1);
      if (sign >= 4 && tag.substr(sign - 4, 4) == " id=" && !ids.insert(value).second)
        return "twice: id " + value;
      sign = close;
    }
    if (alone.contains(name) || tag.ends_with('/')) continue;
    if (name == "script" || name == "style") {  // their content is no HTML
      at = page.find("</" + name + ">", at);
      if (at == page.npos) return name + " does not end";
      at += name.size() + 3;
      continue;
    }
    open.push_back(name);
  }
  return open.empty() ? "" : "not closed: " + open.back();
}

}  // namespace gurney::page
