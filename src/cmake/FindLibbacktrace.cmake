# Finds libbacktrace, which comes with g++ (Debian: libgcc-12-dev). Defines Libbacktrace::Libbacktrace, Libbacktrace_FOUND,
# LIBBACKTRACE_HEADER and LIBBACKTRACE_LIBRARY.
#
# Both lie in the folder of the g++ that the compiler uses, clang included. Its header is copied, because that folder has
# headers of g++ that clang must not see.
execute_process(COMMAND "${CMAKE_CXX_COMPILER}" -print-file-name=libbacktrace.a
                OUTPUT_VARIABLE libbacktrace OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
get_filename_component(libbacktraceFolder "${libbacktrace}" DIRECTORY)
find_library(LIBBACKTRACE_LIBRARY NAMES backtrace HINTS "${libbacktraceFolder}")
find_file(LIBBACKTRACE_HEADER backtrace.h HINTS "${libbacktraceFolder}/include")
mark_as_advanced(LIBBACKTRACE_HEADER LIBBACKTRACE_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Libbacktrace REQUIRED_VARS LIBBACKTRACE_LIBRARY LIBBACKTRACE_HEADER)

if(Libbacktrace_FOUND AND NOT TARGET Libbacktrace::Libbacktrace)
  configure_file("${LIBBACKTRACE_HEADER}" "${PROJECT_BINARY_DIR}/include/libbacktrace/backtrace.h" COPYONLY)
  add_library(Libbacktrace::Libbacktrace UNKNOWN IMPORTED)
  set_target_properties(Libbacktrace::Libbacktrace PROPERTIES
    IMPORTED_LOCATION "${LIBBACKTRACE_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${PROJECT_BINARY_DIR}/include/libbacktrace")
endif()
