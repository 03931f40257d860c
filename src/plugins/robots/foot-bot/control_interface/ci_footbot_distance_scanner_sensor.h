#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_DISTANCE_SCANNER_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_DISTANCE_SCANNER_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/angles.h>

#include <map>
#include <utility>
#include <vector>

namespace argos {

/**
 * The four infrared heads of the distance scanner of the foot-bot: two for short range, opposite
 * each other, and two for long range across them.
 *
 * Readings are distances from the surface of the body, in cm, by the angle of the beam in the
 * robot's frame, in (-PI,PI]; -1 is too close, -2 nothing in range. There are none while the
 * scanner is off; 2 of each range while it stands; 12 of each, from the last tick, while it turns.
 */
class CCI_FootBotDistanceScannerSensor : public CCI_Sensor {
 public:
  static constexpr Real kTooClose = -1.0;
  static constexpr Real kNothing = -2.0;

  struct SReading {
    CRadians Angle; /**< of the beam, in (-PI,PI], counter-clockwise from ahead */
    Real Distance = kNothing; /**< from the surface of the body, cm; or one of the above */
  };

  typedef std::map<CRadians, Real> TReadingsMap;
  typedef std::pair<CRadians, Real> TMapPair;
  typedef std::vector<SReading> TReadings;
  typedef TReadings TLastReadings;

  CCI_FootBotDistanceScannerSensor();

  /** Both ranges; where two beams look along one angle, the one that sees something. */
  const TReadingsMap& GetReadingsMap() { return m_tReadingsMap; }
  const TReadingsMap& GetShortReadingsMap() { return m_tShortReadingsMap; }
  const TReadingsMap& GetLongReadingsMap() { return m_tLongReadingsMap; }

  /** robot.distance_scanner.short_range[i], .long_range[i] = { angle, distance } */
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;

 protected:
  /** Replaces all readings; allocates only if there are more than ever before. */
  void SetReadings(const TReadings& shortRange, const TReadings& longRange);

  TReadingsMap m_tReadingsMap;
  TReadingsMap m_tShortReadingsMap;
  TReadingsMap m_tLongReadingsMap;

 private:
  void Empty(TReadingsMap& map);
  void Put(TReadingsMap& map, const SReading& reading);

  std::vector<TReadingsMap::node_type> m_spares;  // nodes to use again
};

}  // namespace argos

#endif
