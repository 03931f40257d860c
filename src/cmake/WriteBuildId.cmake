# cmake -D MANIFEST=<file> -D TEMPLATE=<build_id.h.in> -D FOLDER=<folder> -P WriteBuildId.cmake
#   writes build_id.cpp, for the build tree, and build_id.h, which is installed, unless they are up to date.
# A line of the manifest is "<library> <include path> <file>".
file(STRINGS "${MANIFEST}" headers)
set(libraries)
foreach(header IN LISTS headers)
  if(NOT header MATCHES "^([^ ]+) ([^ ]+) (.+)$")
    message(FATAL_ERROR "${MANIFEST}: '${header}' is not '<library> <include path> <file>'")
  endif()
  set(library "${CMAKE_MATCH_1}")
  file(SHA256 "${CMAKE_MATCH_3}" hash)
  list(APPEND libraries ${library})
  list(APPEND headersOf_${library} "${CMAKE_MATCH_2} ${hash}")
endforeach()

list(REMOVE_DUPLICATES libraries)
set(id "")
foreach(library IN LISTS libraries)
  list(SORT headersOf_${library})
  string(SHA256 hash "${headersOf_${library}}")
  string(SUBSTRING "${hash}" 0 12 hash)
  string(APPEND id ";${library}=${hash}")
endforeach()

set(argosHeadersIdDefinition "#define ARGOS_HEADERS_ID \"${id}\"")
configure_file("${TEMPLATE}" "${FOLDER}/build_id.h" @ONLY)
file(CONFIGURE OUTPUT "${FOLDER}/build_id.cpp" CONTENT "// Generated: the hashes of the public headers.
extern \"C\" __attribute__((visibility(\"hidden\"))) const char argosHeadersId[];
const char argosHeadersId[] = \"${id}\";
" @ONLY)
