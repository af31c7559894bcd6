#pragma once

#include <string>
#include <vector>

#include "studies/verification/verify.h"

namespace gurney::report {

/// A line: the case, its worst check, its time; in full every check and the parameters; what failed
/// with its derivation in any case.
std::string verification_text(const verification::CaseRun& run, bool in_full);

/// How many passed, and which did not.
std::string verification_summary(const std::vector<verification::CaseRun>& runs);

/// One object with `cases`, of which `gurney report` makes a page.
std::string verification_json(const std::vector<verification::CaseRun>& runs);

/// The page docs/verification_tables.md: closed forms, and every check of every case.
std::string verification_markdown(const std::vector<verification::CaseRun>& runs);

}  // namespace gurney::report
