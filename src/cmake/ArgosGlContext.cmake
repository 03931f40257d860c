# Chooses how the off-screen visualization gets an OpenGL context without a display, see ARGOS_GL_CONTEXT. Defines
# ARGOS_GL_CONTEXT_CHOSEN (osmesa or egl) and the target argos_gl_context. Mesa dropped OSMesa in its release 25.1,
# so systems newer than that have EGL alone.
find_package(PkgConfig REQUIRED)
set(ARGOS_GL_CONTEXT_CHOSEN "")
string(TOLOWER "${ARGOS_GL_CONTEXT}" wantedContext)
if(NOT wantedContext MATCHES "^(auto|osmesa|egl)$")
  message(FATAL_ERROR "ARGOS_GL_CONTEXT is '${ARGOS_GL_CONTEXT}'; it must be auto, osmesa or egl")
endif()
foreach(context osmesa egl)
  if(NOT ARGOS_GL_CONTEXT_CHOSEN AND wantedContext MATCHES "^(auto|${context})$")
    pkg_check_modules(ARGOS_${context} QUIET IMPORTED_TARGET GLOBAL ${context})
    if(ARGOS_${context}_FOUND)
      set(ARGOS_GL_CONTEXT_CHOSEN ${context})
    endif()
  endif()
endforeach()
if(NOT ARGOS_GL_CONTEXT_CHOSEN)
  message(FATAL_ERROR "No way to make an OpenGL context without a display: ARGOS_GL_CONTEXT=${ARGOS_GL_CONTEXT}, "
                      "but pkg-config does not find it; install libosmesa6-dev or libegl-dev")
endif()
message(STATUS "Off-screen OpenGL contexts come from ${ARGOS_GL_CONTEXT_CHOSEN}")
add_library(argos_gl_context INTERFACE)
target_link_libraries(argos_gl_context INTERFACE PkgConfig::ARGOS_${ARGOS_GL_CONTEXT_CHOSEN})
