#include <argos3/core/wrappers/lua/lua_limits.h>

#include <argos3/core/utility/errors/argos_exception.h>

namespace argos {

namespace {

constexpr UInt64 kMaxMebibytes = UInt64{1} << 20;  // 1 TiB

}  // namespace

SLuaLimits SLuaLimits::Read(TConfigurationNode& params, const SLuaLimits& defaults) {
  SLuaLimits limits;
  GetNodeAttributeOrDefault(params, "max_instructions", limits.MaxInstructions,
                            defaults.MaxInstructions);
  GetNodeAttributeOrDefault(params, "unsafe", limits.IsUnsafe, defaults.IsUnsafe);
  UInt64 mebi = 0;
  GetNodeAttributeOrDefault(params, "max_memory", mebi, defaults.MaxMemory / kMebi);
  if (mebi > kMaxMebibytes) {
    THROW_ARGOSEXCEPTION(params.GetLocation()
                         << ": <params>: \"max_memory\" must be from 0 (no limit) to "
                         << kMaxMebibytes << " MiB, got " << mebi);
  }
  limits.MaxMemory = mebi * kMebi;
  return limits;
}

}  // namespace argos
