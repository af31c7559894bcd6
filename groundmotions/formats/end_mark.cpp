#include "groundmotions/formats/end_mark.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

bool is_end_mark(std::string_view line) {
  return std::ranges::any_of(words_of(line, " \t\v\f\x1a,;*-=#%.!"), [](std::string_view word) {
    const std::string text = lower(word);
    return text == "end" || text == "eof" || text.starts_with("end_");
  });
}

}  // namespace

std::size_t data_end(const SourceFile& file, std::size_t first) {
  std::size_t last = file.lines().size();
  const auto skip_blanks = [&] {
    while (last > first && is_blank(file.lines()[last - 1])) --last;
  };
  for (skip_blanks(); last > first && is_end_mark(file.lines()[last - 1]); skip_blanks()) --last;
  return last;
}

void read_to_end(const SourceFile& file, std::size_t first, NumberReader& reader) {
  const std::size_t end = data_end(file, first);
  for (std::size_t i = first; i < end; ++i) reader.read_line(i);
  const auto rest = file.lines().begin() + static_cast<std::ptrdiff_t>(end);
  if (std::all_of(rest, file.lines().end(), is_blank)) reader.check_end();
}

}  // namespace gurney::groundmotions
