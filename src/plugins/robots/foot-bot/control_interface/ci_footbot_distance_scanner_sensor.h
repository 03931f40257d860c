#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_DISTANCE_SCANNER_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_DISTANCE_SCANNER_SENSOR_H

#include <argos3/core/control_interface/print_readings.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

#include <ostream>
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

    template <int = 0>
    friend std::ostream& operator<<(std::ostream& stream, const SReading& reading) {
      return PrintReading(stream, "Angle", reading.Angle, "Distance", reading.Distance);
    }
    template <int = 0>
    friend std::ostream& operator<<(std::ostream& stream, const std::vector<SReading>& readings) {
      return PrintReadings(stream, readings);
    }
  };

  typedef std::map<CRadians, Real> TReadingsMap;
  typedef std::pair<CRadians, Real> TMapPair;
  typedef std::vector<SReading> TReadings;
  typedef TReadings TLastReadings;

  CCI_FootBotDistanceScannerSensor();

  /** Both ranges; of two beams with the same angle, the one that hits a body. */
  const TReadingsMap& GetReadingsMap() {
    Fill(m_tReadingsMap, m_isBothStale, true, true);
    return m_tReadingsMap;
  }
  const TReadingsMap& GetShortReadingsMap() { return FillShort(); }
  const TReadingsMap& GetLongReadingsMap() { return FillLong(); }

 protected:
  /**
   * Replaces all readings. A map is filled when it is read first after that, because few
   * controllers read all of them; this allocates only if there are more readings than ever before.
   */
  void SetReadings(const TReadings& shortRange, const TReadings& longRange);

  // filled by the functions that return them, from the last SetReadings()
  mutable TReadingsMap m_tReadingsMap;
  mutable TReadingsMap m_tShortReadingsMap;
  mutable TReadingsMap m_tLongReadingsMap;

 private:
  const char* GetLuaName() const override { return "distance_scanner"; }
  /** robot.distance_scanner.short_range[i], .long_range[i] = { angle, distance } */
  void WriteReadings(CLuaTable& table) const override;
  void ListNumbers(CNumberList& list) const override;
  const TReadingsMap& FillShort() const {
    Fill(m_tShortReadingsMap, m_isShortStale, true, false);
    return m_tShortReadingsMap;
  }
  const TReadingsMap& FillLong() const {
    Fill(m_tLongReadingsMap, m_isLongStale, false, true);
    return m_tLongReadingsMap;
  }
  void Fill(TReadingsMap& map, bool& isStale, bool withShort, bool withLong) const;
  void Put(TReadingsMap& map, const SReading& reading) const;

  // readings of the last SetReadings()
  TReadings m_short;
  TReadings m_long;
  mutable bool m_isBothStale = false;
  mutable bool m_isShortStale = false;
  mutable bool m_isLongStale = false;
  mutable std::vector<TReadingsMap::node_type> m_spares;  // unused nodes
};

}  // namespace argos

#endif
