#include "studies/build_info/cpu_needs.h"

namespace gurney::build_info {
namespace {

#ifdef __AVX__
constexpr bool kAvx = true;
#else
constexpr bool kAvx = false;
#endif
#ifdef __AVX2__
constexpr bool kAvx2 = true;
#else
constexpr bool kAvx2 = false;
#endif
#ifdef __FMA__
constexpr bool kFma = true;
#else
constexpr bool kFma = false;
#endif
#ifdef __BMI__
constexpr bool kBmi = true;
#else
constexpr bool kBmi = false;
#endif
#ifdef __BMI2__
constexpr bool kBmi2 = true;
#else
constexpr bool kBmi2 = false;
#endif
#ifdef __AVX512F__
constexpr bool kAvx512f = true;
#else
constexpr bool kAvx512f = false;
#endif

}  // namespace

constinit const CpuNeeds kCpuNeeds{kAvx, kAvx2, kFma, kBmi, kBmi2, kAvx512f};

}  // namespace gurney::build_info
