# Finds the functions that load libraries, dlopen() and others. Sets DLFCN_FOUND, DLFCN_INCLUDE_DIR, DLFCN_INCLUDE_DIRS,
# DLFCN_LIBRARY and DLFCN_LIBRARIES; the libraries are empty where the C library has these functions.
cmake_policy(VERSION 3.22)
find_path(DLFCN_INCLUDE_DIR dlfcn.h)
mark_as_advanced(DLFCN_INCLUDE_DIR)
set(DLFCN_INCLUDE_DIRS "${DLFCN_INCLUDE_DIR}")
set(DLFCN_LIBRARY "${CMAKE_DL_LIBS}")
set(DLFCN_LIBRARIES "${CMAKE_DL_LIBS}")
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(DLFCN REQUIRED_VARS DLFCN_INCLUDE_DIR)
