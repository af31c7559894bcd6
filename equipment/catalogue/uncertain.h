#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "equipment/catalogue/sampler.h"

namespace gurney::equipment {

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
    SampleErrors none;
    run(step, none);
  }

  /// The same for a step that may find errors: those of the model as stated go to the document.
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

  /// The same into a list of its own.
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
