# The page becomes part of the program: its files as strings.
set(TUMBLE_PAGE_FOLDER ${CMAKE_CURRENT_SOURCE_DIR}/src/view/page)
foreach(file index.html view.css view.js icon.svg)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${TUMBLE_PAGE_FOLDER}/${file})
  file(READ ${TUMBLE_PAGE_FOLDER}/${file} TUMBLE_PAGE_${file})
endforeach()
configure_file(${TUMBLE_PAGE_FOLDER}/page.cpp.in ${CMAKE_BINARY_DIR}/view_page.cpp @ONLY)
target_sources(tumble_view PRIVATE ${CMAKE_BINARY_DIR}/view_page.cpp)

# Beast is compiled in one file, by itself.
set_source_files_properties(${CMAKE_CURRENT_SOURCE_DIR}/src/view/server.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
target_include_directories(tumble_view SYSTEM PRIVATE ${TUMBLE_IMGUI_INCLUDE})
