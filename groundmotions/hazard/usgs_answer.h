#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/config/document.h"
#include "engine/config/range.h"
#include "groundmotions/hazard/published_measure.h"

namespace gurney::groundmotions {

/// The total mean hazard curve of one measure.
struct UsgsCurve {
  PublishedMeasure measure;
  const config::Node* levels;  ///< as many as rates
  const config::Node* rates;
};

/// The disaggregation of all sources for one measure.
struct UsgsDisaggregation {
  PublishedMeasure measure;
  const config::Node* total;
};

/// An answer of the services of the USGS for hazard curves and disaggregations (National Seismic
/// Hazard Models), which is JSON: `response.hazardCurves[]` and `response.disaggs[]` of the
/// present ones (ws/nshmp/MODEL/dynamic), `response[]` of those before them (nshmp-haz-ws), which the Unified
/// Hazard Tool asks. Of the components of an answer, "Total" is of all sources.
class UsgsAnswer {
 public:
  /// @throws Error unless it is a JSON file with a response
  explicit UsgsAnswer(const std::string& path);

  /// One or more. @throws Error with the path of the element; for a disaggregation
  std::vector<UsgsCurve> curves() const;

  /// One or more. @throws Error with the path of the element; for hazard curves
  std::vector<UsgsDisaggregation> disaggregations() const;

  /// A number of a summary such as {"name": "Mean (over all sources)", "data": [{"name": "m",
  /// "value": 7.1}]}.
  /// @param summary  a part of its name
  /// @param names    how the name of the number may end
  /// @throws Error with the path of the element; for a number that is not `allowed`
  double summed_up(const UsgsDisaggregation& of, const std::string& summary,
                   const std::vector<std::string>& names, const config::Range& allowed) const;

  [[noreturn]] void fail(const config::Node& at, const std::string& message) const;

 private:
  const config::Node& member(const config::Node& of, const std::string& key,
                             config::Node::Kind kind) const;
  const config::Node& total_of(const config::Node& result) const;
  PublishedMeasure measure_of(const config::Node& result) const;
  std::vector<const config::Node*> results(const std::string& key) const;

  config::Document document_;
  const config::Node* response_ = nullptr;
  bool old_ = false;  ///< an answer of nshmp-haz-ws
};

}  // namespace gurney::groundmotions
