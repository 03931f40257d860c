#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_LIMITS_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_LIMITS_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/** What a Lua state may use and do. */
struct SLuaLimits {
  static constexpr UInt64 kMebi = UInt64{1} << 20;

  /** instructions of the virtual machine that one call may execute; 0 = no limit, which makes
   * scripts faster */
  UInt64 MaxInstructions = 100000000;
  UInt64 MaxMemory = 64 * kMebi; /**< bytes; 0 = no limit */
  /** the script may load bytecode and libraries, and use all of "debug" and finalizers */
  bool IsUnsafe = false;

  /**
   * Reads the attributes "max_instructions", "max_memory" (MiB) and "unsafe" of <params>.
   * @param defaults  for attributes that are missing.
   * @throws CARGoSException if a value is out of range.
   */
  static SLuaLimits Read(TConfigurationNode& params, const SLuaLimits& defaults);
};

}  // namespace argos

#endif
