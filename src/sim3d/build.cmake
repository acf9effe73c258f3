# The hot loops, built once per instruction set and chosen at run time (src/sim3d/kernels.cpp). No file outside
# src/sim3d/kernels is ever built with more than the baseline. -Wno-psabi: packs are passed only between inlined functions.
# -Wno-maybe-uninitialized: g++ 12 says so of its own _mm512_sqrt_pd (GCC bug 105593).
file(GLOB TUMBLE_KERNELS CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/kernels/*.cpp)
set(TUMBLE_ISA_FLAGS_baseline "")
set(TUMBLE_ISA_FLAGS_v3 -march=x86-64-v3)
set(TUMBLE_ISA_FLAGS_v4 -march=x86-64-v4 -mprefer-vector-width=512)
foreach(isa baseline v3 v4)
  if(NOT isa STREQUAL baseline AND NOT CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    continue()
  endif()
  add_library(tumble_kernels_${isa} OBJECT ${TUMBLE_KERNELS})
  target_include_directories(tumble_kernels_${isa} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/src)
  target_link_libraries(tumble_kernels_${isa} PRIVATE tumble_options)
  target_compile_options(tumble_kernels_${isa} PRIVATE -O3 -Wno-psabi -Wno-maybe-uninitialized ${TUMBLE_ISA_FLAGS_${isa}})
  target_compile_definitions(tumble_kernels_${isa} PRIVATE TUMBLE_ISA=isa_${isa})
  target_link_libraries(tumble_sim3d PRIVATE $<TARGET_OBJECTS:tumble_kernels_${isa}>)
  target_compile_definitions(tumble_sim3d PRIVATE TUMBLE_HAS_isa_${isa})
endforeach()
