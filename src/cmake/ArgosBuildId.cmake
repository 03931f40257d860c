# Hashes of the public headers, by which the core refuses a plug-in that was compiled against other headers.
#
# They are computed when the build runs, not when it is configured. In the build tree they are in one object file,
# of which every target that links the core has a copy: an edited header recompiles that file and what includes the
# header, and nothing else. Installed, they are a literal in <argos3/core/build_id.h>, so that users' plug-ins carry
# the hashes of the headers that they were compiled against.
#
#   argos_add_public_header(<library> <include path> <file>)   for each header that is installed
#   argos_share_build_id(<core>)                               for the target that all others link
#   argos_add_build_id()                                       once, after all headers were added

# config.h is not among the hashed headers: what of it changes a layout is in the build id by itself.
function(argos_add_public_header library path file)
  set_property(GLOBAL APPEND PROPERTY ARGOS_PUBLIC_HEADERS "${library} ${path} ${file}")
endfunction()

function(argos_share_build_id core)
  # an object library passes the object to the library or program that it is linked into
  set(isLinked "$<NOT:$<STREQUAL:$<TARGET_PROPERTY:TYPE>,OBJECT_LIBRARY>>")
  target_sources(${core} PRIVATE $<TARGET_OBJECTS:argos_build_id>
    INTERFACE "$<BUILD_INTERFACE:$<${isLinked}:$<TARGET_OBJECTS:argos_build_id>>>")
endfunction()

function(argos_add_build_id)
  get_property(headers GLOBAL PROPERTY ARGOS_PUBLIC_HEADERS)
  set(files)
  foreach(header IN LISTS headers)
    string(REGEX REPLACE "^[^ ]+ [^ ]+ " "" file "${header}")
    list(APPEND files "${file}")
  endforeach()
  set(folder "${PROJECT_BINARY_DIR}/generated/build_id")
  string(REPLACE ";" "\n" manifest "${headers}")
  file(CONFIGURE OUTPUT "${folder}/public_headers.txt" CONTENT "${manifest}\n" @ONLY)

  set(script "${PROJECT_SOURCE_DIR}/src/cmake/WriteBuildId.cmake")
  set(template "${PROJECT_SOURCE_DIR}/src/core/build_id.h.in")
  add_custom_command(OUTPUT "${folder}/build_id.cpp" "${folder}/build_id.h"
    COMMAND "${CMAKE_COMMAND}" -D "MANIFEST=${folder}/public_headers.txt" -D "TEMPLATE=${template}"
            -D "FOLDER=${folder}" -P "${script}"
    DEPENDS ${files} "${folder}/public_headers.txt" "${script}" "${template}"
    COMMENT "Hashing the public headers" VERBATIM)
  add_library(argos_build_id OBJECT "${folder}/build_id.cpp")
  target_link_libraries(argos_build_id PRIVATE argos_options)

  set(argosHeadersIdDefinition
    "extern \"C\" __attribute__((visibility(\"hidden\"))) const char argosHeadersId[];
#define ARGOS_HEADERS_ID ::argosHeadersId")
  configure_file("${template}" "${PROJECT_BINARY_DIR}/include/config/argos3/core/build_id.h" @ONLY)
  install(FILES "${folder}/build_id.h" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/argos3/core"
    COMPONENT dev)
endfunction()
