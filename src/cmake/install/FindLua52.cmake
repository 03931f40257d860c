# find_package(Lua52) of a project for ARGoS finds ARGoS's own Lua. Sets LUA52_FOUND and what ARGoSLua.cmake lists.
cmake_policy(VERSION 3.22)
include("${CMAKE_CURRENT_LIST_DIR}/ARGoSLua.cmake")
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Lua52 REQUIRED_VARS LUA_LIBRARY LUA_INCLUDE_DIR VERSION_VAR LUA_VERSION_STRING)
