#pragma once

#include <string>
#include <vector>

#include "studies/findings/findings.h"

/// Findings as text, JSON and Markdown. Nothing here knows what they are about.
namespace gurney::render {

/// For a terminal: facts in two columns, tables as wide as their cells, sentences broken at its
/// width. What has no label is left out.
std::string text(const findings::Section& section);
std::string text(const std::vector<findings::Section>& sections);
std::string text(const findings::Table& table);

/// Prints facts with a key in SI units, ended by a newline.
std::string json(const findings::Section& section);

/// An array of objects, one for each section.
std::string json(const std::vector<findings::Section>& sections);

/// A `|` in a cell is escaped.
std::string markdown(const findings::Table& table);

}  // namespace gurney::render
