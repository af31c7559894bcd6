#pragma once

/// Instruction sets this program was compiled to use. A constant without any code, so that it can
/// be read on a CPU that has none of them.
namespace gurney::build_info {

struct CpuNeeds {
  bool avx, avx2, fma, bmi, bmi2, avx512f;
};

extern const CpuNeeds kCpuNeeds;

}  // namespace gurney::build_info
