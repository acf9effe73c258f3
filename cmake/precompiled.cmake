# The large headers, parsed once for all files: half of a build from nothing would go into parsing them again. A file
# must still include what it uses; presets asan and tsan build without this and the next option and would notice.
option(TUMBLE_PRECOMPILED_HEADERS "parse the large headers once for all files" OFF)

# What is parsed with the headers is a third of the rest: eight files of a folder at once share it.
option(TUMBLE_UNITY_BUILD "compile the files of a folder of src eight at a time" OFF)

if(TUMBLE_PRECOMPILED_HEADERS)
  set(TUMBLE_LARGE_HEADERS <Eigen/Core> <Eigen/Geometry> <algorithm> <array> <cmath> <filesystem> <fmt/format.h>
                           <functional> <map> <memory> <nlohmann/json.hpp> <optional> <span> <string> <variant> <vector>)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/precompiled.cpp CONTENT "")
  function(tumble_precompiled_set name options)
    add_library(${name} OBJECT ${CMAKE_BINARY_DIR}/precompiled.cpp)
    target_link_libraries(${name} PRIVATE Eigen3::Eigen fmt::fmt nlohmann_json::nlohmann_json doctest::doctest
                                          Threads::Threads ${options})
    target_precompile_headers(${name} PRIVATE ${TUMBLE_LARGE_HEADERS} ${ARGN})
  endfunction()
  tumble_precompiled_set(tumble_headers tumble_options)
  tumble_precompiled_set(tumble_test_headers tumble_test_options <doctest/doctest.h>)
endif()

# For programs and libraries: set tumble_headers; for tests: tumble_test_headers.
function(tumble_precompile target set)
  if(TUMBLE_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} REUSE_FROM ${set})
    # Lets ccache see which precompiled header was used.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
  endif()
endfunction()
