#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_PLACED_READINGS_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_PLACED_READINGS_H

#include <argos3/core/utility/math/angles.h>
#include <argos3/core/wrappers/lua/lua_table.h>

#include <vector>

/*
 * Readings that say where their sensors are, for the sources of control interfaces: a READING has a
 * Value and an Angle, or a Value and an Offset, and is made from the two.
 */

namespace argos {

/**
 * Readings of 0.
 * @param where  CRadians or CVector2(UInt32 i): the angle or offset of sensor i.
 */
template <typename READING, typename WHERE>
std::vector<READING> MakeReadings(UInt32 num, WHERE&& where) {
  std::vector<READING> readings;
  readings.reserve(num);
  for (UInt32 i = 0; i < num; ++i) {
    readings.emplace_back(0.0, where(i));
  }
  return readings;
}

/**
 * Readings of 0 from an even ring, counter-clockwise, with angles in (-PI,PI].
 * @param startAngle  of the first, degrees.
 */
template <typename READING>
std::vector<READING> MakeRing(UInt32 num, Real startAngle) {
  return MakeReadings<READING>(num, [num, startAngle](UInt32 i) {
    return ToRadians(CDegrees(startAngle + 360.0 / num * i)).SignedNormalize();
  });
}

/** Writes the list of { angle, value }; angles never change. */
template <typename READING>
void WriteAngularReadings(CLuaTable& table, const std::vector<READING>& readings) {
  table.SetRecords(readings, [](CLuaTable& record, const READING& reading) {
    record.Set("value", reading.Value);
    if (record.IsNew()) {
      record.Set("angle", reading.Angle);
    }
  });
}

/** Writes the list of { offset, value }; offsets never change. */
template <typename READING>
void WriteOffsetReadings(CLuaTable& table, const std::vector<READING>& readings) {
  table.SetRecords(readings, [](CLuaTable& record, const READING& reading) {
    record.Set("value", reading.Value);
    if (record.IsNew()) {
      record.Set("offset", reading.Offset);
    }
  });
}

}  // namespace argos

#endif
