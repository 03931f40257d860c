# Writes what scripts/check_headers.py needs to check the public headers, to <build>/header_checks/: of each target the include
# roots that it sees (<target>.roots), its headers (<target>.headers), and the compiler with its warnings (compiler).
#
#   argos_check_headers(<target> <prefix> <headers>)   for the public headers of each target, a list passed by name
#   argos_add_header_checks()                          once, after all targets were added; the target header_checks runs the script

# Registers headers, whose paths are relative to argos3/<prefix>.
function(argos_check_headers target prefix headersVariable)
  if(NOT ${headersVariable})
    return()
  endif()
  set(paths ${${headersVariable}})
  list(TRANSFORM paths PREPEND "argos3/${prefix}/")
  list(JOIN paths "\n" lines)
  set(folder "${PROJECT_BINARY_DIR}/header_checks")
  file(CONFIGURE OUTPUT "${folder}/${target}.headers" CONTENT "${lines}\n" @ONLY)
  file(GENERATE OUTPUT "${folder}/${target}.roots"
    CONTENT "$<JOIN:$<REMOVE_DUPLICATES:$<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>>,\n>\n")
  set_property(GLOBAL APPEND PROPERTY ARGOS_CHECKED_TARGETS ${target})
endfunction()

function(argos_add_header_checks)
  get_property(targets GLOBAL PROPERTY ARGOS_CHECKED_TARGETS)
  list(JOIN targets "\n" lines)
  set(folder "${PROJECT_BINARY_DIR}/header_checks")
  file(CONFIGURE OUTPUT "${folder}/targets" CONTENT "${lines}\n" @ONLY)
  file(GENERATE OUTPUT "${folder}/compiler"
    CONTENT "${CMAKE_CXX_COMPILER}\n$<JOIN:$<TARGET_PROPERTY:argos_options,INTERFACE_COMPILE_OPTIONS>,\n>\n")
  find_package(Python3 COMPONENTS Interpreter QUIET)
  if(Python3_Interpreter_FOUND)
    add_custom_target(header_checks
      COMMAND "${Python3_EXECUTABLE}" "${PROJECT_SOURCE_DIR}/scripts/check_headers.py" "${PROJECT_BINARY_DIR}"
      VERBATIM USES_TERMINAL)
  endif()
endfunction()
