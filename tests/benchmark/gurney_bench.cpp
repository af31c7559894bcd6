#include <fmt/core.h>

#include <cstdlib>
#include <exception>
#include <string_view>

#include "tests/benchmark/sections.h"

/// Prints accuracy and speed in one run. `--quick` takes a small ensemble;
/// `--predictability`, `--refine`, `--settled`, `--replicas` and `--step-control` print the tables of
/// docs/theory/predictability.md and solver.md alone, `--intervals` that of
/// docs/theory/statistics.md, `--cost`, `--parts` and `--rooms` those of docs/performance.md, and so does
/// `--studies JOB...`.
int main(int argc, char** argv) try {
  using namespace gurney::benchmark;
  const bool quick = argc > 1 && std::string_view(argv[1]) == "--quick";
  if (argc > 1 && std::string_view(argv[1]) == "--predictability") {
    print_predictability(100);
    return 0;
  }
  if (argc > 1 && std::string_view(argv[1]) == "--replicas") {
    print_replicas(argc > 2 ? std::atoi(argv[2]) : 200);
    return 0;
  }
  if (argc > 1 && std::string_view(argv[1]) == "--intervals") {
    print_intervals(argc > 2 ? std::atoi(argv[2]) : 2000);
    return 0;
  }
  if (argc > 1 && std::string_view(argv[1]) == "--cost") {
    print_cost();
    return 0;
  }
  if (argc > 1 && std::string_view(argv[1]) == "--parts") {
    print_loaded_carts();
    return 0;
  }
  if (argc > 1 && std::string_view(argv[1]) == "--rooms") {
    print_rooms(argc > 2 ? std::atoi(argv[2]) : 12);
    return 0;
  }
  if (argc > 1 && std::string_view(argv[1]) == "--studies") {
    print_studies({argv + 2, argv + argc}, 8);
    return 0;
  }
  if (argc > 1 && std::string_view(argv[1]) == "--refine") {
    print_refine(argc > 2 ? std::atoi(argv[2]) : 100);
    return 0;
  }
  if (argc > 1 && std::string_view(argv[1]) == "--settled") {
    print_settled(argc > 2 ? std::atoi(argv[2]) : 20);
    return 0;
  }
  if (argc > 1 && std::string_view(argv[1]) == "--step-control") {
    print_step_control(argc > 2 ? std::atoi(argv[2]) : 100);
    return 0;
  }
  print_pulling_accuracy();
  print_ensemble_accuracy(quick ? 2 : 8, quick ? 3 : 7);
  print_peers();
  print_predictability(quick ? 4 : 20);
  print_spectra();
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 1;
}
