# run.json names the version it was made with.
target_compile_definitions(tumble_run PRIVATE TUMBLE_VERSION="${PROJECT_VERSION}")

# Checkpoints and run.json name a mark of all that decides bits, too: the folders that step, place bodies and measure, how
# they are compiled, and with what. It is computed anew when one of these files changes, and then one small file is
# compiled. It may change once too often (a comment), never too seldom.
set(TUMBLE_MARKED ${CMAKE_CURRENT_SOURCE_DIR}/cmake/options.cmake ${CMAKE_CURRENT_SOURCE_DIR}/cmake/kernels.cmake)
foreach(layer base contact fit observe solid scene solver discs sim2d sim3d hard2d)
  file(GLOB_RECURSE found CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/src/${layer}/*.h
       ${CMAKE_CURRENT_SOURCE_DIR}/src/${layer}/*.cpp)
  list(APPEND TUMBLE_MARKED ${found})
endforeach()
list(JOIN TUMBLE_MARKED "\n" marked)
set(TUMBLE_MARKED_WITH "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}, Eigen ${Eigen3_VERSION}, Box2D ${box2d_VERSION}")
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/build_mark.list CONTENT "${marked}" @ONLY)
add_custom_command(
  OUTPUT ${CMAKE_BINARY_DIR}/build_mark.cpp
  COMMAND ${CMAKE_COMMAND} -D FILES=${CMAKE_BINARY_DIR}/build_mark.list -D ROOT=${CMAKE_CURRENT_SOURCE_DIR}
          -D "WITH=${TUMBLE_MARKED_WITH}" -D TEMPLATE=${CMAKE_CURRENT_SOURCE_DIR}/src/run/build_mark.cpp.in
          -D OUTPUT=${CMAKE_BINARY_DIR}/build_mark.cpp -P ${CMAKE_CURRENT_SOURCE_DIR}/cmake/build_mark.cmake
  DEPENDS ${TUMBLE_MARKED} ${CMAKE_BINARY_DIR}/build_mark.list ${CMAKE_CURRENT_SOURCE_DIR}/src/run/build_mark.cpp.in
          ${CMAKE_CURRENT_SOURCE_DIR}/cmake/build_mark.cmake
  COMMENT "Marking the sources that decide bits"
  VERBATIM)
add_library(tumble_build_mark STATIC ${CMAKE_BINARY_DIR}/build_mark.cpp)
target_include_directories(tumble_build_mark PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/src)
target_link_libraries(tumble_build_mark PRIVATE tumble_options)
target_link_libraries(tumble_run PUBLIC tumble_build_mark)
