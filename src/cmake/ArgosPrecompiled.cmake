# Precompiled headers: the standard library's for libraries, those and Catch2's for tests. No header of this project is
# precompiled, so an edit recompiles only the sources that include the header, and a source that lacks an include of
# one does not compile. scripts/check_headers.py and the build for robots use none of them: there, every header and every
# control interface compiles with its own includes alone. So does scripts/tidy.sh with every source.
#
#   argos_precompile(<target> library|test)   lets a target use the headers that were compiled once for its kind

if(ARGOS_PRECOMPILE_HEADERS)
  set(argosStandardHeaders <algorithm> <array> <atomic> <chrono> <cmath> <functional> <iostream> <limits> <map> <memory>
    <mutex> <optional> <set> <sstream> <string> <thread> <unordered_map> <vector>)
  file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/generated/precompiled.cpp" CONTENT "" @ONLY)

  add_library(argos_precompiled_library OBJECT "${PROJECT_BINARY_DIR}/generated/precompiled.cpp")
  target_link_libraries(argos_precompiled_library PRIVATE argos_options)
  target_precompile_headers(argos_precompiled_library PRIVATE ${argosStandardHeaders})

  if(ARGOS_BUILD_TESTING)
    add_library(argos_precompiled_test OBJECT "${PROJECT_BINARY_DIR}/generated/precompiled.cpp")
    target_link_libraries(argos_precompiled_test PRIVATE argos_options argos_test_options Catch2::Catch2)
    # what CMake gives to programs; the options of a precompiled header must be those of its users
    set_target_properties(argos_precompiled_test PROPERTIES POSITION_INDEPENDENT_CODE OFF)
    target_compile_options(argos_precompiled_test PRIVATE -fPIE)
    target_precompile_headers(argos_precompiled_test PRIVATE ${argosStandardHeaders} <filesystem> <fstream>
      <catch2/catch.hpp>)
  endif()

  # what ccache needs to reuse precompiled headers and what was compiled with them; see also CMAKE_CXX_COMPILER_LAUNCHER
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(argos_options INTERFACE -fpch-preprocess)
  elseif(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    target_compile_options(argos_options INTERFACE "SHELL:-Xclang -fno-pch-timestamp")
  endif()
endif()

function(argos_precompile target kind)
  if(ARGOS_PRECOMPILE_HEADERS)
    target_precompile_headers(${target} REUSE_FROM argos_precompiled_${kind})
  endif()
endfunction()
