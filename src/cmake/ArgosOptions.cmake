# argos_options: what every target of this project is compiled and linked with. It is never exported: users choose
# their own language level and warnings.
add_library(argos_options INTERFACE)
target_compile_features(argos_options INTERFACE cxx_std_20)

# Same input, same bits: a multiplication and an addition fused into one instruction round once instead of twice, and
# whether they are fused depends on the compiler, its version and the inlining around them. So never fuse.
target_compile_options(argos_options INTERFACE -ffp-contract=off)
# Nothing reads errno after mathematical functions or traps exceptions of arithmetic. Without these two, g++ vectorizes no
# loop with a comparison or a square root; results are the same.
target_compile_options(argos_options INTERFACE -fno-math-errno -fno-trapping-math)
# No path of this machine gets into programs through __FILE__, which all assertions of tests contain.
target_compile_options(argos_options INTERFACE "-fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=")

set(argosWarnings -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual)
# g++ 12 warns wrongly of overlapping copies in "text" + string, and of copies that are too long if <string> is
# precompiled: GCC bug 105329. AddressSanitizer finds real ones.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  list(APPEND argosWarnings -Wno-restrict -Wno-stringop-overflow)
endif()
if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # in a unit of several sources each source counts as a header, whose anonymous namespaces would be suspicious
  list(APPEND argosWarnings -Wno-subobject-linkage)
endif()
if(ARGOS_WERROR)
  list(APPEND argosWarnings -Werror)
endif()
target_compile_options(argos_options INTERFACE ${argosWarnings})

if(ARGOS_BUILD_NATIVE)
  target_compile_options(argos_options INTERFACE -march=native)
endif()
if(ARGOS_CHECK_INVARIANTS)
  # beside ARGOS_ASSERT, every index into a container of the standard library
  target_compile_definitions(argos_options INTERFACE ARGOS_CHECK_INVARIANTS _GLIBCXX_ASSERTIONS)
endif()
if(ARGOS_SANITIZE)
  # -g1: lines for the stacks that are reported; Debug adds the rest
  target_compile_options(argos_options INTERFACE -fsanitize=${ARGOS_SANITIZE} -fno-omit-frame-pointer
                                                 -fno-sanitize-recover=all $<$<NOT:$<CONFIG:Debug>>:-g1>)
  target_link_options(argos_options INTERFACE -fsanitize=${ARGOS_SANITIZE})
endif()

if(ARGOS_FUZZ)
  # counts which branches an input reaches
  target_compile_options(argos_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

# No program references a symbol of a plug-in that only registers itself; a linker that drops unreferenced libraries by
# default (Ubuntu) would leave it out.
if(NOT APPLE)
  target_link_options(argos_options INTERFACE -Wl,--no-as-needed)
  # Functions are called within their library without a look-up by name in all libraries, half of the time of a start. Data,
  # such as static variables of templates, are still shared by all libraries.
  target_link_options(argos_options INTERFACE -Wl,-Bsymbolic-functions)
  if(NOT ARGOS_SANITIZE)
    target_link_options(argos_options INTERFACE -Wl,--no-undefined)
  endif()
endif()

# argos_test_options: what tests are compiled with on top of that. The tested code is in the libraries; the tests
# themselves need to compile fast, not to run fast: sanitizers double the time of an optimizing compiler. The macros of
# Catch2 without a try block in each of them: an exception still ends its test case as a failure.
add_library(argos_test_options INTERFACE)
target_compile_definitions(argos_test_options INTERFACE CATCH_CONFIG_FAST_COMPILE)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # g++ 12 sees copies out of bounds where many strings are concatenated: GCC bug 105651
  target_compile_options(argos_test_options INTERFACE -Wno-array-bounds -Wno-stringop-overread)
endif()
if(ARGOS_SANITIZE)
  target_compile_options(argos_test_options INTERFACE -O0)
else()
  target_compile_options(argos_test_options INTERFACE $<$<CONFIG:Release>:-O1>)
endif()

set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

# The build tree has the layout of the install tree, so bin/../lib/argos3 is right in both.
set(ARGOS_LIBRARY_SUBDIR lib/argos3)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/${ARGOS_LIBRARY_SUBDIR}")
set(CMAKE_INSTALL_RPATH "$ORIGIN;$ORIGIN/../${ARGOS_LIBRARY_SUBDIR}")
