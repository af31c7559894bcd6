#include <fstream>

#include "studies/results/results_file.h"
#include "tests/support/synthetic_run.h"

/// Writes a results file of a made-up run to the path given.
int main(int argc, char** argv) {
  if (argc != 2) return 2;
  std::ofstream(argv[1], std::ios::binary)
      << gurney::study::results_image(gurney::synthetic_facts(), gurney::synthetic_response());
}
