#pragma once

#include <string>
#include <vector>

#include "studies/explanation/facts.h"

namespace gurney::explanation {

/// The finding of the explained item in one sentence, without a line break.
std::string headline(const Explanation& of);

/// One event as a line of words, without its time.
std::string words_of(const Event& event, bool name_item, const study::UnitSystem& units);

/// "12 mm", "1.23 m"
std::string length_words(double metres, const study::UnitSystem& units);

/// A part of the text: a heading and what stands below it.
struct TextPart {
  struct Line {
    std::string label;  ///< such as a time
    std::string words;
  };
  std::string heading;
  std::vector<Line> lines;
  bool table = false;  ///< whose lines stay as they are
};

/// Everything below the headline. None of a run that failed.
std::vector<TextPart> parts_of(const Explanation& of);

/// Everything in words, for a terminal.
std::string text(const Explanation& of);

}  // namespace gurney::explanation
