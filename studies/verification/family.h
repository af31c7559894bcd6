#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "studies/verification/runner.h"

namespace gurney::verification {

/// A number that a case depends on. The closed form and the tolerances hold in [low, high].
struct Parameter {
  std::string name, unit;
  double low, high;
  bool whole = false;  ///< takes whole numbers only
};

/// One set of parameters.
struct Case {
  std::string name;            ///< within its family
  std::vector<double> values;  ///< as Family::parameters
};

/// What a reader needs to know of a closed form.
struct Statement {
  std::string name;      ///< `constant_pull`
  std::string group;     ///< `pulling`, `sliding`, `casters`, ...
  std::string title;     ///< what happens, in a few words
  std::string equation;  ///< the reference
  std::string source;    ///< the original publication, or the law it follows from
};

/// Cases of one closed form.
struct Family {
  Statement statement;
  std::vector<Parameter> parameters;
  std::vector<Case> cases;
  std::function<Findings(const std::vector<double>& values, const Runner& runner)> run;
  std::function<bool(const std::vector<double>& values)> possible;  ///< what ranges cannot express
  bool on_stock = false;                                            ///< stock Bullet can run it
  bool drawn = true;  ///< makes sense for parameters that nobody chose
};

/// Case `draw_<seed>`: every parameter uniform in its range (Philox, engine/base/random), drawn
/// again until the set is possible. It depends on the seed and the family's name alone.
/// @throws Error when a thousand sets are not
Case draw_case(const Family& family, std::uint64_t seed);

/// A parameter and its place in a struct of them.
template <class Set>
struct Field {
  Parameter parameter;
  double Set::*member;
};

/// The family of a function of a struct of numbers.
template <class Set>
Family make_family(Statement statement, std::vector<Field<Set>> fields,
                   const std::vector<std::pair<std::string, Set>>& cases,
                   Findings (*run)(const Set&, const Runner&),
                   bool (*possible)(const Set&) = nullptr) {
  Family family;
  family.statement = std::move(statement);
  for (const Field<Set>& field : fields) family.parameters.push_back(field.parameter);
  for (const auto& [name, set] : cases) {
    family.cases.push_back({name, {}});
    for (const Field<Set>& field : fields) family.cases.back().values.push_back(set.*field.member);
  }
  const auto set_of = [fields = std::move(fields)](const std::vector<double>& values) {
    Set set;
    for (std::size_t i = 0; i < fields.size(); ++i) set.*fields[i].member = values[i];
    return set;
  };
  family.run = [set_of, run](const std::vector<double>& values, const Runner& runner) {
    return run(set_of(values), runner);
  };
  family.possible = [set_of, possible](const std::vector<double>& values) {
    return !possible || possible(set_of(values));
  };
  return family;
}

}  // namespace gurney::verification
