#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/random/draw.h"
#include "engine/base/vector.h"
#include "engine/config/document.h"
#include "engine/config/range.h"
#include "equipment/catalogue/stated_quantity.h"

namespace gurney::equipment {

/// What is wrong with one sample of a model.
class SampleErrors {
 public:
  void add(const config::Spot& spot, const std::string& message);
  void add(const Error& error);
  void note_in(config::Document& document) const;
  bool none() const { return entries_.empty(); }
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

  /// The same draw for a part of its own.
  Sampler of_part(const std::string& part) const;

  /// The same for one element of an array of tables, `item[1]`: a part whose names begin with
  /// `item`, so that its index does not matter.
  Sampler of_element(const std::string& element, const std::string& part) const;

  Sampler into(std::vector<Assumption>& list) const;  ///< with another list

  void error(const config::Spot& spot, const std::string& message);
  void error(const Error& error);

  /// A bound that depends on other numbers, met as stated: a drawn number beyond it is an error.
  void check_drawn(const StatedQuantity& quantity, const config::Range& range);

  bool clean() const { return errors_->none(); }  ///< no step found an error so far

 private:
  std::string variable(const std::string& name) const;
  double in_unit(const StatedQuantity& quantity) const;

  std::vector<Assumption>* list_;
  SampleErrors* errors_;
  std::optional<Draw> draw_;
  std::string element_;
};

}  // namespace gurney::equipment
