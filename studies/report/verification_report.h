#pragma once

#include <string>
#include <vector>

#include "studies/convergence/convergence.h"
#include "studies/findings/findings.h"
#include "studies/units/unit_system.h"
#include "studies/verification/verify.h"

namespace gurney::report {

/// A line: the case, its worst check, its time; in full every check and the parameters; what failed
/// with its derivation in any case.
std::string verification_text(const verification::CaseRun& run, bool in_full);

/// How many passed, and which did not.
std::string verification_summary(const std::vector<verification::CaseRun>& runs);

/// Every case with its checks, as `gurney verify --json` prints it.
findings::Section verification_facts(const std::vector<verification::CaseRun>& runs);

/// The same with one of everything, as a pattern for a reader.
findings::Section example_of_verification_facts();

/// Report on all of them: failed checks first, cases by group, closed forms, all numbers.
findings::Section verification_findings(const findings::Section& facts);

/// The cases of verification_facts(), the failed ones first.
std::vector<const findings::Section*> verified_cases(const findings::Section& facts);

/// |error| over tolerance of a check; infinite: failed without one.
double used_of(const findings::Table& checks, std::size_t row);

/// The page docs/verification_tables.md: closed forms, and every check of every case.
std::string verification_markdown(const std::vector<verification::CaseRun>& runs);

/// Report of a convergence study, in SI unless units are chosen.
findings::Section convergence_findings(const study::Convergence& found,
                                       const study::UnitSystem& units = {});

}  // namespace gurney::report
