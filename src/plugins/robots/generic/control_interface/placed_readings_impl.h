#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_PLACED_READINGS_IMPL_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_PLACED_READINGS_IMPL_H

#include <argos3/core/wrappers/lua/lua_table.h>
#include <argos3/plugins/robots/generic/control_interface/placed_readings.h>

#include <algorithm>

/*
 * Definitions of the members of CPlacedSensors, for the sources of control interfaces: each source
 * instantiates the template explicitly.
 */

namespace argos {

/**
 * Directions of the sensors on an even ring, counter-clockwise, for SSensorPlaces::GetPlace. The
 * first sensor points half a step to the left of straight ahead.
 * @tparam NUM  number of sensors on the ring.
 * @return in (-PI,PI].
 */
template <UInt32 NUM>
CRadians GetAngleOnRing(UInt32 index) {
  return ToRadians(CDegrees(180.0 / NUM + 360.0 / NUM * index)).SignedNormalize();
}

template <class READINGS, class BASE>
CPlacedSensors<READINGS, BASE>::CPlacedSensors() {
  const auto& places = READINGS::TSensor::kPlaces;
  this->m_tReadings.reserve(places.Num);
  for (UInt32 i = 0; i < places.Num; ++i) {
    this->m_tReadings.emplace_back(0.0, places.GetPlace(i));
  }
}

template <class READINGS, class BASE>
void CPlacedSensors<READINGS, BASE>::WriteReadings(CLuaTable& table) const {
  using TReading = typename READINGS::SReading;
  table.SetRecords(
      this->m_tReadings, "value", [](const TReading& reading) { return reading.Value; },
      [](CLuaTable& record, const TReading& reading) {
        // places never change
        record.Set(READINGS::kLuaPlace, READINGS::GetPlace(reading));
      });
}

template <class READINGS, class BASE>
std::vector<CCI_Sensor::SColumn> CPlacedSensors<READINGS, BASE>::GetReadingColumns() const {
  return CCI_Sensor::MakeNumberedColumns(this->m_tReadings.size());
}

template <class READINGS, class BASE>
void CPlacedSensors<READINGS, BASE>::CopyReadings(Real* numbers, std::size_t count) const {
  const std::size_t num = std::min(count, this->m_tReadings.size());
  for (std::size_t i = 0; i < num; ++i) {
    numbers[i] = this->m_tReadings[i].Value;
  }
}

template <class READINGS, class BASE>
const char* CPlacedSensors<READINGS, BASE>::GetLuaName() const {
  return READINGS::TSensor::kPlaces.LuaName;
}

}  // namespace argos

#endif
