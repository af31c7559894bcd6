#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "studies/verification/check.h"

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

/// Statement of a closed form for readers.
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
  std::function<void(const std::vector<double>& values, Runner& runner)> run;
  std::function<bool(const std::vector<double>& values)> possible;  ///< what ranges cannot express
  bool on_stock = false;                                            ///< stock Bullet can run it
  bool drawn = true;  ///< makes sense for parameters that nobody chose
};

/// All closed forms that the engine is held against, in the order of `gurney verify`; each has its
/// file in studies/verification/cases.
std::vector<Family> all_families();

inline Family on_stock_too(Family family) {
  family.on_stock = true;
  return family;
}

inline Family never_drawn(Family family) {
  family.drawn = false;
  return family;
}

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

template <class Set>
Field<Set> in(double Set::*member, std::string name, std::string unit, double low, double high,
              bool whole = false) {
  return {{std::move(name), std::move(unit), low, high, whole}, member};
}

/// A field with the name of its member: FIELD(Pull, force, "N", 20, 150).
#define FIELD(Set, name, ...) in(&Set::name, #name, __VA_ARGS__)

template <class First, class... Others>
std::vector<First> fields(First first, Others... others) {
  return {std::move(first), std::move(others)...};
}

/// A case with the first of the numbers; the others are those of a `Set` by default.
template <class... Numbers>
Case at(std::string name, Numbers... numbers) {
  return {std::move(name), {static_cast<double>(numbers)...}};
}

/// Every combination of a case of each list: names and numbers one after the other.
std::vector<Case> combinations(const std::vector<std::vector<Case>>& lists);

template <class... Each>
std::vector<Case> cases(Each... each) {
  return {std::move(each)...};
}

/// The family of a function of a struct of numbers, its fields in their order.
template <class Set>
Family make_family(Statement statement, std::vector<Field<Set>> fields, std::vector<Case> cases,
                   void (*run)(const Set&, Runner&), bool (*possible)(const Set&) = nullptr) {
  Family family;
  family.statement = std::move(statement);
  for (const Field<Set>& field : fields) family.parameters.push_back(field.parameter);
  for (Case& each : cases)
    for (std::size_t i = each.values.size(); i < fields.size(); ++i)
      each.values.push_back(Set{}.*fields[i].member);
  family.cases = std::move(cases);
  const auto set_of = [fields = std::move(fields)](const std::vector<double>& values) {
    Set set;
    for (std::size_t i = 0; i < fields.size(); ++i) set.*fields[i].member = values[i];
    return set;
  };
  family.run = [set_of, run](const std::vector<double>& values, Runner& runner) {
    run(set_of(values), runner);
  };
  family.possible = [set_of, possible](const std::vector<double>& values) {
    return !possible || possible(set_of(values));
  };
  return family;
}

}  // namespace gurney::verification
