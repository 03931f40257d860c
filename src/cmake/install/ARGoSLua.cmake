# Finds the Lua that ARGoS runs controllers with, for ARGoSConfig.cmake and for FindLua51.cmake, FindLua52.cmake and
# FindLua53.cmake: a project that includes ARGoS's headers of Lua needs this version, whichever it was written for.
# Sets LUA_INCLUDE_DIR, LUA_LIBRARY, LUA_LIBRARIES and LUA_VERSION_STRING.
cmake_policy(VERSION 3.22)
find_path(ARGOS_LUA_INCLUDE_DIR lua.h PATH_SUFFIXES lua5.4 lua54 lua-5.4)
find_library(ARGOS_LUA_LIBRARY NAMES lua5.4 lua54 lua-5.4 lua)
mark_as_advanced(ARGOS_LUA_INCLUDE_DIR ARGOS_LUA_LIBRARY)
set(LUA_INCLUDE_DIR "${ARGOS_LUA_INCLUDE_DIR}")
set(LUA_LIBRARY "${ARGOS_LUA_LIBRARY}")
set(LUA_LIBRARIES "${ARGOS_LUA_LIBRARY}")
set(LUA_VERSION_STRING "5.4")
