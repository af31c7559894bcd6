#pragma once

#include <string>
#include <vector>

namespace gurney::cli {

/// Words of the command line as an inline table of TOML, so that they are read as strictly as a
/// file: "high_pass", "corner_hz=0.1" with the first key "step" are
/// `{ step = "high_pass", corner_hz = 0.1 }`. Numbers, true, false, arrays and tables stay as they
/// are; everything else becomes text.
/// @throws Error for a word after the first without `=`.
std::string inline_table(const std::string& first_key, const std::vector<std::string>& words);

/// Errors of a document made of an option's text, in terms of the option as it was typed:
/// `--step:1:49: processing[0].corner_hz = -1: must be ...` becomes
/// `--step "high_pass corner_hz=-1": corner_hz = -1: must be ...`.
/// @param path  of the table in the document, such as "processing[0]"
std::string option_error(const std::string& option, const std::string& text,
                         const std::string& path, const std::string& message);

/// Cut at blanks.
std::vector<std::string> words_of(const std::string& text);

}  // namespace gurney::cli
