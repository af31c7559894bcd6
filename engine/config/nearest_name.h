#pragma once

#include <string>
#include <vector>

namespace gurney::config {

/// Number of insertions, deletions, substitutions and swaps of neighbours that turn `a` into `b`;
/// no part is edited twice (Damerau 1964, optimal string alignment).
int edit_distance(const std::string& a, const std::string& b);

/// Addition to a message about an unknown name: `; did you mean 'x'?` when a known name is near
/// or begins so (a forgotten unit), else `; known: a, b, c`; empty when nothing is known. Capitals,
/// blanks, dots, hyphens and underscores do not count.
std::string suggestion(const std::string& name, const std::vector<std::string>& known);

/// suggestion() without the list of known names.
std::string near_name(const std::string& name, const std::vector<std::string>& known);

}  // namespace gurney::config
