#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/random/distribution.h"
#include "engine/base/random/draw.h"
#include "engine/base/vector.h"
#include "engine/config/document.h"
#include "engine/config/range.h"
#include "engine/config/table.h"
#include "equipment/catalogue/assumption.h"

namespace gurney::equipment {

/// The possible values of a number, as the `distribution` of its quantity says
/// (docs/formats/equipment_file.md).
struct Uncertainty {
  Distribution distribution;  ///< in the unit of the key
  CorrelationGroup group;
  std::string reason;  ///< assumption behind it; empty: it has a source
};

/// Reads the table `key` of `parent`. Errors are noted; the result is empty then.
/// @param range  what the number may be: the distribution must stay within
std::optional<Uncertainty> read_uncertainty(config::Table& parent, const std::string& key,
                                            const config::Range& range);

/// Unit of a number by the end of its key: `kg` for `chassis.mass_kg`, `1` for a pure number.
std::string unit_of_key(const std::string& key);

/// A number as its file states it: its value, what the value rests on, and how it may be.
struct StatedQuantity {
  double value = 0;                          ///< in the unit of its key
  std::optional<Uncertainty> uncertainty{};  ///< none: it has its value in a draw too
  std::string reason{};                      ///< assumption behind the value; empty: none
  double low = 0, high = 0;                  ///< its range, in the unit of its key
  config::Spot spot{};                       ///< its key; of a component with `.x` or `[2]`
  double factor = 1, divisor = 1;            ///< to SI

  double si(double in_unit) const { return in_unit * factor / divisor; }
};

/// Numbers or flags of equal parts. What they rest on is one entry for all.
struct QuantityList {
  std::vector<StatedQuantity> quantities;
  Assumption choice{};          ///< without a reason: none
  bool chosen_in_draws = true;  ///< false: a draw has an entry for each drawn number instead
};

/// A text as its file states it.
struct StatedText {
  std::string text;
  Assumption choice{};  ///< without a reason: none
};

/// Errors of one sample of a model.
class SampleErrors {
 public:
  void add(const config::Spot& spot, const std::string& message);
  void add(const Error& error);
  void note_in(config::Document& document) const;
  bool empty() const { return entries_.empty(); }
  void raise() const;  ///< @throws Error with all, if there are any

 private:
  struct Entry {
    std::optional<config::Spot> spot;
    std::string message;
  };
  std::vector<Entry> entries_;
};

/// Gives the numbers of one sample of a model: as stated, or of a draw. Each that no source backs,
/// or that was drawn, goes to a list. A number depends on the draw and its name alone.
class Sampler {
 public:
  /// The list and the errors must outlive it.
  Sampler(std::vector<Assumption>& list, SampleErrors& errors, std::optional<Draw> draw = {});

  double operator()(const StatedQuantity& quantity);  ///< SI
  Vector3 operator()(const std::array<StatedQuantity, 3>& components);
  std::vector<double> operator()(const QuantityList& list);
  void note(const Assumption& choice);  ///< one without a reason is none

  /// Samples a part of its own in this draw.
  Sampler of_part(const std::string& part) const;

  /// Samples one element of an array of tables, `item[1]`: a part whose names begin with
  /// `item`, so that its index does not matter.
  Sampler of_element(const std::string& element, const std::string& part) const;

  Sampler into(std::vector<Assumption>& list) const;  ///< with another list

  void error(const config::Spot& spot, const std::string& message);
  void error(const Error& error);

  /// A bound that depends on other numbers, met as stated: a drawn number beyond it is an error.
  void check_drawn(const StatedQuantity& quantity, const config::Range& range);

  bool clean() const { return errors_->empty(); }  ///< no step found an error so far

 private:
  std::string variable(const std::string& name) const;
  double in_unit(const StatedQuantity& quantity) const;

  std::vector<Assumption>* list_;
  SampleErrors* errors_;
  std::optional<Draw> draw_;
  std::string element_;
};

/// A model as its files state it, read and validated once: what is fixed, and the steps that put
/// each quantity where it belongs and derive what follows from them. sample() runs the steps:
///
///     Uncertain<BearingFriction> bearing;
///     bearing.set(&BearingFriction::coulomb, in.number("coulomb_n_m", Range::not_negative()));
///     BearingFriction drawn = sample(bearing, Draw(seed, run));
///
/// Where T has a member `assumptions`, that is the list of its numbers; else they go to the list of
/// the model it is a part of.
template <class T>
class Uncertain {
 public:
  using Step = std::function<void(T&, Sampler&)>;

  explicit Uncertain(T fixed = {}) : fixed_(std::move(fixed)), stated_(fixed_) {}

  const T& stated() const& { return stated_; }  ///< every number at its value
  T stated() && { return std::move(stated_); }

  /// One more step, which is run at once on the model as stated.
  void add(Step step) {
    SampleErrors ignored;
    run(step, ignored);
  }

  /// Adds a step that may find errors: those of the model as stated go to the document.
  void add(config::Document& document, Step step) {
    SampleErrors errors;
    run(step, errors);
    errors.note_in(document);
  }

  /// @param target  a pointer to a member, or a function that gives a reference to it
  /// @param stated  a quantity, an array or a list of them
  template <class Target, class Stated>
  void set(Target target, Stated stated) {
    add([target, stated = std::move(stated)](T& model, Sampler& of) {
      assign(std::invoke(target, model), stated, of);
    });
  }

  /// Sets a number whose assumption goes into a list of its own.
  template <class Target>
  void set(Target target, StatedQuantity stated, std::vector<Assumption> T::*list) {
    add([target, stated = std::move(stated), list](T& model, Sampler& of) {
      std::invoke(target, model) = of.into(model.*list)(stated);
    });
  }

  template <class Target, class Part>
  void set(Target target, Uncertain<Part> part) {
    add([target, part = std::move(part)](T& model, Sampler& of) {
      std::invoke(target, model) = part.sample(of);
    });
  }

  template <class Target, class Part>
  void append(Target target, Uncertain<Part> part) {
    add([target, part = std::move(part)](T& model, Sampler& of) {
      std::invoke(target, model).push_back(part.sample(of));
    });
  }

  T sample(Sampler of) const {
    T model = fixed_;
    apply(model, of);
    return model;
  }

  /// The steps alone, on a model that is there already.
  void apply(T& model, Sampler of) const {
    Sampler own = of_list(model, of);
    for (const Step& step : steps_) step(model, own);
  }

 private:
  static Sampler of_list(T& model, const Sampler& of) {
    if constexpr (requires { model.assumptions; })
      return of.into(model.assumptions);
    else
      return of;
  }

  template <class Value>
  static void assign(Value& value, const StatedQuantity& stated, Sampler& of) {
    value = of(stated);
  }

  template <class Vector, std::size_t size>
  static void assign(Vector& vector, const std::array<StatedQuantity, size>& stated, Sampler& of) {
    for (std::size_t i = 0; i < size; ++i) vector[static_cast<int>(i)] = of(stated[i]);
  }

  template <class Value>
  static void assign(Value& value, const QuantityList& stated, Sampler& of) {
    const std::vector<double> values = of(stated);
    if constexpr (std::is_same_v<Value, bool>)
      value = values.front() != 0;
    else
      value.assign(values.begin(), values.end());
  }

  void run(Step& step, SampleErrors& errors) {
    std::vector<Assumption> unlisted;
    Sampler as_stated = of_list(stated_, Sampler(unlisted, errors));
    step(stated_, as_stated);
    steps_.push_back(std::move(step));
  }

  T fixed_, stated_;
  std::vector<Step> steps_;
};

/// The model in a draw; without one, every number at its value.
/// @throws Error where these numbers do not go together, with the place of each
template <class T>
T sample(const Uncertain<T>& model, const std::optional<Draw>& draw) {
  SampleErrors errors;
  std::vector<Assumption> unlisted;
  T sampled = model.sample(Sampler(unlisted, errors, draw));
  errors.raise();
  return sampled;
}

}  // namespace gurney::equipment
