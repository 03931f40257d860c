# Compiles each public header alone, as C++17, in two translation units of its own:
#   lean     as the simulator sees it: with ARGOS_WITHOUT_COMPANIONS and the include roots that its target links
#   users    as users' code sees it: with its companions and every include root. It must bring what
#            src/testing/compat/companions.txt says.
#
#   argos_check_headers(<target> <prefix> <root> <headers>)   for the public headers of each target
#   argos_add_header_checks()                                 once, after all targets were added
#
# Some public headers include companions, which users' code expects but which they do not need themselves, unless
# ARGOS_WITHOUT_COMPANIONS is defined, as for the simulator and its plug-ins: these include what they use.

# The include roots of all targets, which for users are one.
add_library(argos_user_headers INTERFACE)

# Registers headers, a list passed by name, whose paths are relative to <root>/argos3/<prefix>.
function(argos_check_headers target prefix root headersVariable)
  target_include_directories(argos_user_headers INTERFACE "${root}")
  # a sanitizer finds nothing in what is only compiled
  if(NOT ARGOS_BUILD_TESTING OR ARGOS_SANITIZE OR NOT ${headersVariable})
    return()
  endif()
  set(paths ${${headersVariable}})
  list(TRANSFORM paths PREPEND "${prefix}/")
  set_property(GLOBAL APPEND PROPERTY ARGOS_CHECKED_TARGETS ${target})
  set_property(GLOBAL PROPERTY ARGOS_CHECKED_HEADERS_OF_${target} ${paths})
  foreach(path IN LISTS paths)
    set_property(GLOBAL PROPERTY ARGOS_CHECKED_FILE_${path} "${root}/argos3/${path}")
  endforeach()
endfunction()

# Compiles a source for each header of a target in the object library header_checks_<kind>_<target>: the include of the
# header, then the content of the variable argosEpilogue_<path of the header>.
function(argos_add_header_check kind target)
  set(name header_checks_${kind}_${target})
  get_property(paths GLOBAL PROPERTY ARGOS_CHECKED_HEADERS_OF_${target})
  set(sources)
  foreach(path IN LISTS paths)
    set(source "${PROJECT_BINARY_DIR}/header_checks/${kind}/${path}.cpp")
    set(text "// Generated: compiles one public header alone.\n#include <argos3/${path}>\n${argosEpilogue_${path}}")
    file(CONFIGURE OUTPUT "${source}" CONTENT "${text}" @ONLY)
    list(APPEND sources "${source}")
  endforeach()
  add_library(${name} OBJECT ${sources})
  target_link_libraries(${name} PRIVATE ${target} ${ARGN})
  target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}/src/testing/compat")
  argos_set_header_check_options(${name})
  add_dependencies(header_checks ${name})
endfunction()

function(argos_set_header_check_options target)
  target_compile_options(${target} PRIVATE $<TARGET_PROPERTY:argos_options,INTERFACE_COMPILE_OPTIONS> -O0 -g0)
  # in a unity build, only one header would be the first
  set_target_properties(${target} PROPERTIES CXX_STANDARD 17 CXX_STANDARD_REQUIRED ON UNITY_BUILD OFF)
endfunction()

# Turns the file of companions into code that is compiled behind the include of each header.
macro(argos_read_companions)
  # the one that every header brings; the others are checked against what it brings without a precompiled header
  set(standardHeaders core/utility/datatypes/standard_headers.h)
  set(argosEpilogue_${standardHeaders} "#include <standard_headers_in_use.h>\n")

  set(companions "${PROJECT_SOURCE_DIR}/src/testing/compat/companions.txt")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${companions}")
  file(STRINGS "${companions}" lines REGEX "^[^#]")
  set(header)
  foreach(line IN LISTS lines)
    string(STRIP "${line}" path)
    if(line STREQUAL path)
      set(header "${path}")
      set(path "${standardHeaders}")
    endif()
    foreach(each IN ITEMS "${header}" "${path}")
      get_property(file GLOBAL PROPERTY ARGOS_CHECKED_FILE_${each})
      if(NOT file)
        message(FATAL_ERROR "${companions}: no target has the public header '${each}'")
      endif()
    endforeach()
    file(STRINGS "${file}" guard REGEX "^#ifndef " LIMIT_COUNT 1)
    string(APPEND argosEpilogue_${header} "${guard}\n#error \"${header} must bring ${path}\"\n#endif\n")
  endforeach()
endmacro()

function(argos_add_header_checks)
  get_property(targets GLOBAL PROPERTY ARGOS_CHECKED_TARGETS)
  if(NOT targets)
    return()
  endif()
  add_custom_target(header_checks)
  foreach(target IN LISTS targets)
    argos_add_header_check(lean ${target})
    target_compile_definitions(header_checks_lean_${target} PRIVATE ARGOS_WITHOUT_COMPANIONS)
  endforeach()
  if(NOT ARGOS_BUILD_FOR_SIMULATOR OR ARGOS_SANITIZE)
    # most companions are not built; or the release build checks them
    return()
  endif()
  argos_read_companions()
  foreach(target IN LISTS targets)
    argos_add_header_check(users ${target} argos_user_headers argos3::core)
    argos_precompile(header_checks_users_${target} user)
  endforeach()
endfunction()
