#include "studies/report/wrapped.h"

#include <sstream>

namespace gurney::report {
namespace {

constexpr std::size_t kColumns = 100;

}  // namespace

std::string wrapped(const std::string& text, std::size_t indent, std::size_t used) {
  std::istringstream words(text);
  std::string result, word;
  std::size_t column = used;
  bool first = true;
  while (words >> word) {
    if (!first && column + 1 + word.size() > kColumns) {
      result.append("\n").append(indent, ' ');
      column = indent;
    } else if (!first) {
      result += " ";
      ++column;
    }
    result += word;
    column += word.size();
    first = false;
  }
  return result;
}

}  // namespace gurney::report
