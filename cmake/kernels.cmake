# The hot loops of a solver, src/<layer>/kernels, built once per instruction set and chosen at run time
# (src/<layer>/kernels.cpp). No other file is ever built with more than the baseline. -Wno-psabi: packs are passed only
# between inlined functions. -Wno-maybe-uninitialized: g++ 12 says so of its own _mm512_sqrt_pd (GCC bug 105593).
set(TUMBLE_ISA_FLAGS_baseline "")
set(TUMBLE_ISA_FLAGS_v3 -march=x86-64-v3)
set(TUMBLE_ISA_FLAGS_v4 -march=x86-64-v4 -mprefer-vector-width=512)

function(tumble_kernels layer)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/src/${layer}/kernels/*.cpp)
  foreach(isa baseline v3 v4)
    # clang 14 cannot ask the processor for a level of x86-64; what it builds, the fuzzers, needs no speed.
    if(NOT isa STREQUAL baseline AND
       (NOT CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" OR CMAKE_CXX_COMPILER_ID MATCHES Clang))
      continue()
    endif()
    set(kernels tumble_${layer}_kernels_${isa})
    add_library(${kernels} OBJECT ${sources})
    target_include_directories(${kernels} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/src)
    target_link_libraries(${kernels} PRIVATE tumble_options)
    target_compile_options(${kernels} PRIVATE -O3 -Wno-psabi $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>
                           ${TUMBLE_ISA_FLAGS_${isa}})
    if(TUMBLE_FUZZ) # no fuzzer steps a world; under the sanitizers these loops take longest of all to compile
      target_compile_options(${kernels} PRIVATE -O1 -fno-sanitize=all)
    endif()
    target_compile_definitions(${kernels} PRIVATE TUMBLE_ISA=isa_${isa})
    target_link_libraries(tumble_${layer} PRIVATE $<TARGET_OBJECTS:${kernels}>)
    target_compile_definitions(tumble_${layer} PRIVATE TUMBLE_HAS_isa_${isa})
  endforeach()
endfunction()
