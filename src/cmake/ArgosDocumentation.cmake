# The target documentation, a part of all: the site of guide and API reference, in <build>/site.
find_program(ARGOS_DOXYGEN doxygen)
find_program(ARGOS_MKDOCS mkdocs)
if(NOT ARGOS_DOXYGEN OR NOT ARGOS_MKDOCS)
  message(FATAL_ERROR "ARGOS_DOCUMENTATION is ON, but there is no doxygen or no mkdocs; run: scripts/setup.sh site, or set "
                      "ARGOS_DOCUMENTATION to OFF")
endif()
add_custom_target(documentation ALL
  COMMAND "${CMAKE_COMMAND}" -E env "BUILD_DIR=${PROJECT_BINARY_DIR}" "${PROJECT_SOURCE_DIR}/scripts/site.sh"
          "${PROJECT_BINARY_DIR}/site"
  COMMENT "Writing the site of guide and API reference" VERBATIM USES_TERMINAL)
add_dependencies(documentation run)
