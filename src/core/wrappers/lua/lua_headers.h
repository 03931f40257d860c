#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_HEADERS_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_HEADERS_H

// Lua's own headers, which declare C functions. No other header includes them.
extern "C" {
#include <lauxlib.h>
#include <lua.h>
#include <lualib.h>
}

#endif
