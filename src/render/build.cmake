# Debian's Dear ImGui keeps its header in a folder of its own; as a system folder its warnings stay its own.
find_path(TUMBLE_IMGUI_INCLUDE imgui.h PATH_SUFFIXES imgui REQUIRED)
target_include_directories(tumble_render SYSTEM PRIVATE ${TUMBLE_IMGUI_INCLUDE})
tumble_kernels(render)
