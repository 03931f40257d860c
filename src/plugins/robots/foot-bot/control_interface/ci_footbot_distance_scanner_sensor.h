#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_DISTANCE_SCANNER_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_DISTANCE_SCANNER_SENSOR_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

#include <map>
#include <utility>
#include <vector>

namespace argos {

/**
 * The four infrared heads of the distance scanner of the foot-bot: two for short range, opposite
 * each other, and two for long range across them.
 *
 * Readings are distances from the surface of the body, in cm, by the angle of the beam in the
 * robot's frame, in (-PI,PI]; -1 is too close, -2 nothing in range. There are no readings while
 * the scanner is off; 2 of each range at a fixed angle; 12 of each, from the last tick, while it
 * rotates.
 */
class CCI_FootBotDistanceScannerSensor : public CTableSensor {
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

  /** Both ranges; of two beams with the same angle, the one that hits a body. */
  const TReadingsMap& GetReadingsMap() { return m_tReadingsMap; }
  const TReadingsMap& GetShortReadingsMap() { return m_tShortReadingsMap; }
  const TReadingsMap& GetLongReadingsMap() { return m_tLongReadingsMap; }

  std::vector<SColumn> GetReadingColumns() const override;
  void CopyReadings(Real* numbers, std::size_t count) const override;

 protected:
  /** Replaces all readings; allocates memory only if there are more than in any earlier call. */
  void SetReadings(const TReadings& shortRange, const TReadings& longRange);

  TReadingsMap m_tReadingsMap;
  TReadingsMap m_tShortReadingsMap;
  TReadingsMap m_tLongReadingsMap;

 private:
  const char* GetLuaName() const override { return "distance_scanner"; }
  /** robot.distance_scanner.short_range[i], .long_range[i] = { angle, distance } */
  void WriteReadings(CLuaTable& table) const override;
  void Empty(TReadingsMap& map);
  void Put(TReadingsMap& map, const SReading& reading);

  std::vector<TReadingsMap::node_type> m_spares;  // unused nodes
};

}  // namespace argos

#endif
