#pragma once

#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace gurney {

/// The tables of docs/verification_tables.md, written by `gurney verify --markdown`: cells of each row.
struct VerificationPage {
  std::set<std::vector<std::string>> statements;
  std::vector<std::vector<std::string>> checks;
};

inline VerificationPage verification_page(std::istream& markdown) {
  VerificationPage page;
  for (std::string line; std::getline(markdown, line);) {
    if (!line.starts_with("| `")) continue;
    std::vector<std::string> cells(1);
    for (std::size_t i = 2; i + 1 < line.size(); ++i)
      if (line[i] == '|' && line[i - 1] != '\\')
        cells.emplace_back();
      else
        cells.back() += line[i];
    if (cells.size() == 5) page.statements.insert(cells);
    if (cells.size() != 7) continue;
    if (cells.back() == " as above ") cells.back() = page.checks.back().back();
    page.checks.push_back(cells);
  }
  return page;
}

inline VerificationPage verification_page(const std::string& markdown) {
  std::istringstream text(markdown);
  return verification_page(text);
}

inline VerificationPage shipped_verification_page() {
  std::ifstream file(GURNEY_SOURCE_DIR "/docs/verification_tables.md");
  return verification_page(file);
}

/// The parts of each check that do not depend on numbers: closed form, quantity with unit, derivation.
inline std::set<std::string> words_of_checks(const VerificationPage& page) {
  std::set<std::string> words;
  for (const auto& cells : page.checks) words.insert(cells[0] + cells[1] + cells[6]);
  return words;
}

}  // namespace gurney
