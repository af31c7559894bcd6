#include <dlfcn.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "engine/base/error.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/data_folder.h"
#include "studies/bindings/array_record.h"
#include "studies/bindings/arrays.h"
#include "studies/bindings/finished_run.h"
#include "studies/bindings/study_curves.h"
#include "studies/build_info/build_info.h"
#include "studies/results/names.h"
#include "studies/results/results_file.h"

namespace gurney::bindings {
namespace {

namespace py = pybind11;
using Samples = py::array_t<double, py::array::c_style | py::array::forcecast>;

groundmotions::Record record_of(const Samples& samples, double time_step) {
  require(samples.ndim() == 1 || samples.ndim() == 2,
          "record: must be an array of 1 or 2 dimensions: times, or times and axes");
  const py::ssize_t columns = samples.ndim() == 1 ? 1 : samples.shape(1);
  return array_record({samples.data(), static_cast<std::size_t>(samples.size())},
                      static_cast<std::size_t>(columns), time_step);
}

FinishedRun simulate(const std::string& path, const std::optional<std::string>& text,
                     const std::optional<Samples>& record, double time_step, bool predictability) {
  RunRequest request{path, text, {}, predictability};
  if (record) request.record = record_of(*record, time_step);
  const py::gil_scoped_release others_may_run;
  return run_job(request);
}

/// The bytes of the file that `gurney run` writes. HDF5 keeps its state in one place: the GIL stays.
py::bytes results_bytes(const FinishedRun& run) {
  return study::results_image(run.facts, run.response);
}

/// The data of an installation are beside this library and not beside the interpreter: in the first
/// folder above it that has share/gurney, PREFIX of PREFIX/lib/python3/dist-packages/gurney, or the
/// target of `pip install --target`. The library of a build stands for itself.
void find_data_beside_module() {
  Dl_info library;
  if (dladdr(reinterpret_cast<const void*>(&find_data_beside_module), &library) == 0) return;
  std::filesystem::path place = std::filesystem::absolute(library.dli_fname).parent_path();
  if (!exists(place / equipment::kSourceFolderFile)) {
    while (!exists(place / "share" / "gurney") && place.has_relative_path())
      place = place.parent_path();
    place /= "bin";
  }
  equipment::take_as_program(place / "program");
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const Error& error) {
    const py::object input_error = py::module_::import("gurney.errors").attr("InputError");
    PyErr_SetString(input_error.ptr(), error.what());
  }
}

}  // namespace

PYBIND11_MODULE(_engine, module) {
  find_data_beside_module();
  py::register_exception_translator(&translate);
  module.attr("version") = build_info::build_info().program_version;
  py::class_<FinishedRun>(module, "FinishedRun")
      .def_property_readonly("outcome",
                             [](const FinishedRun& run) { return name_of(run.response.outcome); })
      .def_property_readonly(
          "failed", [](const FinishedRun& run) { return is_failure(run.response.outcome); })
      .def_property_readonly("cause", [](const FinishedRun& run) { return run.response.cause; })
      .def_property_readonly("end_time",
                             [](const FinishedRun& run) { return run.response.end_time; })
      .def_property_readonly("warnings", [](const FinishedRun& run) { return run.facts.warnings; })
      .def_property_readonly(
          "items", [](const FinishedRun& run) { return study::item_names(run.facts.scene); })
      .def("demands", &demands)
      .def("wheels", &wheel_demands)
      .def("points", &point_demands)
      .def("histories", &histories)
      .def("results", &results_bytes);
  module.def("simulate", &simulate, py::arg("path"), py::arg("text"), py::arg("record"),
             py::arg("time_step"), py::arg("predictability"));
  module.def("data_folder", &equipment::data_folder);
  using equipment::DataKind;
  py::enum_<DataKind>(module, "DataKind")
      .value("item", DataKind::kItem)
      .value("caster", DataKind::kCaster);
  module.def("find_data", &equipment::find_data, py::arg("kind"), py::arg("name"),
             py::arg("named_in"));
  define_curves(module);
}

}  // namespace gurney::bindings
