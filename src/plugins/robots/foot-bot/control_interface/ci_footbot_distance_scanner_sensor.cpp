#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_distance_scanner_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

namespace {

// nodes of both ranges while it rotates, once in the map of their range and once in that of both
constexpr size_t kMaxNodes = 48;

void WriteRange(CLuaTable list, const CCI_FootBotDistanceScannerSensor::TReadingsMap& readings) {
  list.SetNewRecords(readings, [](CLuaTable& record, const auto& reading) {
    record.Set("angle", reading.first);
    record.Set("distance", reading.second);
  });
}

}  // namespace

CCI_FootBotDistanceScannerSensor::CCI_FootBotDistanceScannerSensor() {
  m_spares.reserve(kMaxNodes);
}

void CCI_FootBotDistanceScannerSensor::SetReadings(const TReadings& shortRange,
                                                   const TReadings& longRange) {
  m_short = shortRange;
  m_long = longRange;
  m_isBothStale = true;
  m_isShortStale = true;
  m_isLongStale = true;
}

void CCI_FootBotDistanceScannerSensor::Fill(TReadingsMap& map, bool& isStale, bool withShort,
                                            bool withLong) const {
  if (!isStale) {
    return;
  }
  while (!map.empty()) {
    m_spares.push_back(map.extract(map.begin()));
  }
  for (const TReadings* const readings :
       {withShort ? &m_short : nullptr, withLong ? &m_long : nullptr}) {
    for (size_t i = 0; readings != nullptr && i < readings->size(); ++i) {
      Put(map, (*readings)[i]);
    }
  }
  isStale = false;
}

void CCI_FootBotDistanceScannerSensor::Put(TReadingsMap& map, const SReading& reading) const {
  if (m_spares.empty()) {
    TReadingsMap made;
    made.emplace(reading.Angle, reading.Distance);
    m_spares.push_back(made.extract(made.begin()));
  }
  TReadingsMap::node_type node = std::move(m_spares.back());
  m_spares.pop_back();
  node.key() = reading.Angle;
  node.mapped() = reading.Distance;
  auto outcome = map.insert(std::move(node));
  if (!outcome.inserted) {
    if (outcome.position->second < 0.0) {
      outcome.position->second = reading.Distance;
    }
    m_spares.push_back(std::move(outcome.node));
  }
}

void CCI_FootBotDistanceScannerSensor::WriteReadings(CLuaTable& table) const {
  WriteRange(table.MakeTable("short_range"), FillShort());
  WriteRange(table.MakeTable("long_range"), FillLong());
}

void CCI_FootBotDistanceScannerSensor::ListNumbers(CNumberList& list) const {
  list.Add("short_count", "", static_cast<Real>(FillShort().size()));
  list.Add("long_count", "", static_cast<Real>(FillLong().size()));
}

}  // namespace argos
