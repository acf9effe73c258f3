# run.json names the version it was made with.
target_compile_definitions(tumble_run PRIVATE TUMBLE_VERSION="${PROJECT_VERSION}")
