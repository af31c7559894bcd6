#pragma once

#include <string>
#include <vector>

#include "engine/base/error.h"
#include "engine/config/document.h"
#include "engine/config/table.h"

namespace gurney::cli {

/// Words of the command line as an inline table of TOML, so that they are read as strictly as a
/// file: "high_pass", "corner_hz=0.1" with the first key "step" are
/// `{ step = "high_pass", corner_hz = 0.1 }`. Numbers, true, false, arrays and tables stay as they
/// are; everything else becomes text.
/// @throws Error for a word after the first without `=`.
std::string inline_table(const std::string& first_key, const std::vector<std::string>& words);

/// Errors of a document made of an option's text, in terms of the option as it was typed:
/// `--step:1:49: processing[0].corner_hz = -1: must be ...` becomes
/// `--step "high_pass corner_hz=-1": corner_hz = -1: must be ...`. Those of a file that it names stay as
/// they are, with their place.
/// @param path  of the table in the document, such as "processing[0]"
std::string option_error(const std::string& option, const std::string& text,
                         const std::string& path, const std::string& message);

/// Cut at blanks that are not between brackets or double quotes.
std::vector<std::string> words_of(const std::string& text);

/// The value of an option as an inline table. @throws Error in terms of the option as it was typed
std::string option_table(const std::string& option, const std::string& text,
                         const std::string& first_key);

/// The value of an option such as --target "asce7 sds_g=1 sd1_g=0.6", read as a document.
/// @param path   of its table in the document, such as "spectrum" or "processing[0]"
/// @param first  key of the first word, which stands without it
/// @param read   the root of the document -> value, which is not used where an error is noted
/// @throws Error with all errors, in terms of the option as it was typed.
template <class Read>
auto read_option(const std::string& option, const std::string& text, const std::string& path,
                 const std::string& first, const Read& read) {
  const std::string table = option_table(option, text, first);
  try {
    const std::size_t list = path.find("[0]");
    config::Document document(list == std::string::npos
                                  ? path + " = " + table + "\n"
                                  : path.substr(0, list) + " = [" + table + "]\n",
                              option);
    config::Table root = document.root();
    auto value = read(root);
    document.finish();
    return value;
  } catch (const Error& error) {
    throw Error(option_error(option, text, path, error.what()));
  }
}

}  // namespace gurney::cli
