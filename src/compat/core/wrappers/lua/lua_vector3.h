#ifndef ARGOS3_COMPAT_CORE_WRAPPERS_LUA_LUA_VECTOR3_H
#define ARGOS3_COMPAT_CORE_WRAPPERS_LUA_LUA_VECTOR3_H

// the path that users' code includes
#include <argos3/core/wrappers/lua/lua_types.h>

#endif
