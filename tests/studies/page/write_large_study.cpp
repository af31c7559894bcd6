#include "tests/studies/page/large_study.h"

/// Writes a study of 100,000 runs to the path given.
int main(int, char** argv) { gurney::page::large_study().write(argv[1]); }
