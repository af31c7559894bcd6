#include <iostream>

#include "groundmotions/synthetic/clough_penzien.h"

/// Writes the text of groundmotions/records/synthetic_3c.csv to standard output.
int main() { std::cout << gurney::groundmotions::shipped_synthetic_text(); }
