# Writes the file that knows the mark of the sources that decide bits (src/run/build.cmake): 16 digits of a hash over
# their names seen from ROOT and their contents, and over WITH. The file is left alone where the mark is the same.
file(STRINGS ${FILES} files)
set(all "${WITH}\n")
foreach(file IN LISTS files)
  file(SHA256 ${file} hash)
  file(RELATIVE_PATH name ${ROOT} ${file})
  string(APPEND all "${name} ${hash}\n")
endforeach()
string(SHA256 mark "${all}")
string(SUBSTRING ${mark} 0 16 TUMBLE_BUILD_MARK)
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
