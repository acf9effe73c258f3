# Flags that every target gets, each with its reason.
option(TUMBLE_WARNINGS_AS_ERRORS "stop at the first warning" OFF)
set(TUMBLE_SANITIZE "" CACHE STRING "sanitizers, as -fsanitize takes them: address,undefined or thread")

add_library(tumble_options INTERFACE)
target_compile_options(tumble_options INTERFACE -Wall -Wextra -Wshadow -Wpedantic)
# g++ 12 sees overlapping and endless copies in string additions where there are none (GCC bugs 105329, 105651), and,
# with sanitizers, unset members of variants that hold another alternative (GCC bug 105593).
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  target_compile_options(tumble_options INTERFACE -Wno-restrict
                         $<$<CONFIG:Release>:-Wno-stringop-overflow> $<$<CONFIG:Release>:-Wno-array-bounds>)
  if(TUMBLE_SANITIZE)
    target_compile_options(tumble_options INTERFACE -Wno-maybe-uninitialized)
  endif()
endif()
if(TUMBLE_WARNINGS_AS_ERRORS)
  target_compile_options(tumble_options INTERFACE -Werror)
endif()

# Fused multiply-add rounds once instead of twice: two instruction sets would drift apart and bits would differ.
# errno is never read after sqrt, and asking for it keeps the compiler from using the vector instruction.
target_compile_options(tumble_options INTERFACE -ffp-contract=off -fno-fast-math -fno-math-errno -fno-trapping-math)

# Every file must agree on alignment although the hot ones are built for wider registers.
target_compile_definitions(tumble_options INTERFACE EIGEN_MAX_ALIGN_BYTES=32)

# Tests are compiled as often as they are run, and what takes time in them is in the libraries: doctest without a try
# around every comparison, and less of the optimiser.
add_library(tumble_test_options INTERFACE)
target_link_libraries(tumble_test_options INTERFACE tumble_options)
target_compile_options(tumble_test_options INTERFACE -O1)
target_compile_definitions(tumble_test_options INTERFACE DOCTEST_CONFIG_SUPER_FAST_ASSERTS)

if(TUMBLE_SANITIZE)
  target_compile_options(tumble_options INTERFACE -fsanitize=${TUMBLE_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(tumble_options INTERFACE -fsanitize=${TUMBLE_SANITIZE})
endif()

option(TUMBLE_FUZZ "build the fuzzers of tests/fuzz; needs clang" OFF)
if(TUMBLE_FUZZ)
  target_compile_options(tumble_options INTERFACE -fsanitize=fuzzer-no-link)
endif()
