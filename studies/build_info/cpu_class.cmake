# Decides which CPUs the program is built for, from GURNEY_CPU:
#   auto      x86-64-v3 (AVX2, FMA, BMI2) when this machine supports it, else the compiler's baseline
#   generic   the compiler's baseline
#   <value>   -march=<value>
# Sets GURNEY_CPU_CLASS (stored in results) and GURNEY_CPU_FLAGS (given to every target of ours).
set(GURNEY_CPU_CLASS "${GURNEY_CPU}")
if(GURNEY_CPU STREQUAL "auto")
  include(CheckCXXSourceRuns)
  check_cxx_source_runs([[
    int main() {
      __builtin_cpu_init();
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
             __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2") ? 0 : 1;
    }]] GURNEY_MACHINE_IS_X86_64_V3)
  if(GURNEY_MACHINE_IS_X86_64_V3)
    set(GURNEY_CPU_CLASS "x86-64-v3")
  else()
    set(GURNEY_CPU_CLASS "generic")
  endif()
endif()
set(GURNEY_CPU_FLAGS "")
if(GURNEY_CPU_CLASS STREQUAL "generic")
  set(GURNEY_CPU_CLASS "generic ${CMAKE_SYSTEM_PROCESSOR}")
else()
  set(GURNEY_CPU_FLAGS "-march=${GURNEY_CPU_CLASS}")
endif()
message(STATUS "CPU class: ${GURNEY_CPU_CLASS}")
