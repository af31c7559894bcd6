#include "studies/bindings/study_curves.h"

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>

#include "engine/base/append_all.h"
#include "engine/base/error.h"
#include "engine/config/document.h"
#include "studies/analysis/fragility_result.h"
#include "studies/limit_states/limit_state_reader.h"
#include "studies/plan/assessment_files.h"

namespace gurney::bindings {
namespace {

namespace py = pybind11;
using study::FragilityResult;
using study::StudyData;
using Pair = std::pair<double, double>;

const study::UnitSystem kUnits("si");  ///< of texts, as of the numbers beside them

Pair pair_of(const statistics::Interval& interval) { return {interval.low, interval.high}; }

std::shared_ptr<StudyData> study_of(const std::string& path,
                                    const std::vector<std::string>& limit_states) {
  return std::make_shared<StudyData>(path, study::AssessmentRequest{.limit_states = limit_states});
}

/// Name and definition of each.
py::list limit_states(const StudyData& data) {
  py::list all;
  for (const study::LimitState& each : data.limit_states())
    all.append(py::make_tuple(each.name, each.words));
  return all;
}

/// The runs that did not fail, by their number, and whether they exceed.
py::tuple outcomes(const StudyData& data, const std::string& state) {
  std::vector<std::size_t> runs;
  for (std::size_t i = 0; i < data.configurations().size(); ++i) append_all(runs, data.runs_of(i));
  std::ranges::sort(runs);
  return py::make_tuple(runs, data.exceedances(study::index_of(data.limit_states(), state), runs));
}

FragilityResult curve(const StudyData& data, const std::string& state, std::size_t configuration,
                      const std::string& measure, bool cloud, double confidence) {
  return study::fragility_of(
      data, {.state = study::index_of(data.limit_states(), state),
             .configuration = configuration,
             .measure = measure,
             .confidence = confidence,
             .method = cloud ? study::CurveMethod::kCloud : study::CurveMethod::kOwn});
}

FragilityResult curve_of_outcomes(const StudyData& data,
                                  const std::map<std::size_t, bool>& exceeded,
                                  std::size_t configuration, const std::string& measure,
                                  double confidence) {
  return study::fragility_of_outcomes(
      data, exceeded,
      {.configuration = configuration, .measure = measure, .confidence = confidence});
}

py::dict numbers(const FragilityResult& of) {
  const study::ReportUnit unit = kUnits.of(of.measure.units);
  const auto known = of.curve();
  py::dict all;
  all["configuration"] = of.configuration;
  all["words"] = of.words;
  all["measure"] = of.measure.name;
  all["units"] = of.measure.units;
  all["runs"] = of.runs;
  all["exceeded"] = of.exceeded;
  all["records"] = of.records;
  all["failed"] = of.failed;
  all["method"] = of.by_cloud() ? "cloud" : of.capacities ? "capacities" : "outcomes";
  all["reason"] = known ? "" : study::no_curve_text(of, unit);
  all["theta"] = known ? known->theta : std::nan("");
  all["beta"] = known ? known->beta : std::nan("");
  all["covariance"] = of.covariance();
  all["effective_records"] = of.band.effective;
  const bool has = known && !of.band.too_few;
  all["theta_interval"] = has ? py::cast(pair_of(of.band.theta)) : py::none();
  all["beta_interval"] = has ? py::cast(pair_of(of.band.beta)) : py::none();
  std::vector<std::array<double, 4>> stripes;
  for (std::size_t i = 0; i < of.stripes.size(); ++i)
    stripes.push_back(
        {of.stripes[i].im, of.stripes[i].runs, of.stripes[i].exceeded, of.isotonic[i]});
  all["stripes"] = stripes;
  std::vector<std::array<double, 3>> band;
  for (std::size_t i = 0; i < of.band.of_curve.size(); ++i)
    band.push_back({of.im[i], of.band.of_curve[i].low, of.band.of_curve[i].high});
  all["band"] = band;
  all["range"] = Pair{of.audit.lowest, of.audit.highest};
  all["cautions"] = study::cautions(of.audit, unit);
  return all;
}

double probability(const FragilityResult& of, double im) {
  const auto known = of.curve();
  return known ? known->probability(im) : std::nan("");
}

/// None without a curve.
py::object rate(const FragilityResult& of, const study::SiteHazard& hazard) {
  if (!of.curve()) return py::none();
  const study::SiteRate found = study::site_rate(*of.curve(), of.band, of.audit, hazard.curve);
  py::dict all;
  all["per_year"] = found.rate;
  all["interval"] = found.has_interval ? py::cast(pair_of(found.interval)) : py::none();
  all["supported"] = found.is_supported();
  all["cautions"] = study::cautions(found, kUnits.of(of.measure.units));
  return all;
}

study::SiteHazard hazard(const std::string& path, const std::optional<std::string>& text) {
  if (!text) return study::read_hazard_file(path);
  config::Document document(*text, path);
  return study::read_site_hazard(document);
}

/// The points of a table; none of a power law.
std::vector<double> points(const study::SiteHazard& of) {
  const auto& pieces = of.curve.pieces();
  if (!std::isfinite(pieces.back().high)) return {};
  std::vector<double> im;
  for (const auto& each : pieces) im.push_back(each.low);
  im.push_back(pieces.back().high);
  return im;
}

}  // namespace

void define_curves(py::module_& module) {
  py::class_<study::SiteHazard>(module, "Hazard")
      .def(py::init(&hazard), py::arg("path"), py::arg("text"))
      .def_readonly("measure", &study::SiteHazard::measure)
      .def("points", &points)
      .def("rate", [](const study::SiteHazard& of, double im) {
        return of.curve.rate(im).value_or(std::nan(""));
      });
  py::class_<FragilityResult>(module, "Curve")
      .def("numbers", &numbers)
      .def("probability", &probability)
      .def("rate", &rate);
  py::class_<StudyData, std::shared_ptr<StudyData>>(module, "Study")
      .def(py::init(&study_of), py::arg("path"), py::arg("limit_states"))
      .def("limit_states", &limit_states)
      .def("measures", &StudyData::measures)
      .def("outcomes", &outcomes)
      .def("curve", &curve)
      .def("curve_of_outcomes", &curve_of_outcomes);
}

}  // namespace gurney::bindings
