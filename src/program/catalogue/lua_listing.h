#ifndef ARGOS3_PROGRAM_CATALOGUE_LUA_LISTING_H
#define ARGOS3_PROGRAM_CATALOGUE_LUA_LISTING_H

#include <string>
#include <vector>

namespace argos {

class CCI_Controller;

/** An entry of a device's table in Lua. */
struct SLuaEntry {
  std::string Path; /**< "robot.leds.set_all_colors", "robot.proximity[i].value" */
  std::string Type; /**< "function", "number", "list" (an empty one), "vector3", ... */
};

/**
 * Lists what the devices of a controller have added to its table "robot": functions first, then
 * readings. Empty if it is not a controller in Lua, or has no script.
 */
std::vector<SLuaEntry> ListLuaDevices(CCI_Controller& controller);

}  // namespace argos

#endif
