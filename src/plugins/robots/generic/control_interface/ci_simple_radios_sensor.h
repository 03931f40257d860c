#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_SIMPLE_RADIOS_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_SIMPLE_RADIOS_SENSOR_H

#include <argos3/core/utility/datatypes/byte_array.h>
#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

#include <string>
#include <vector>

namespace argos {

/** Receives messages of any size with the robot's radios. */
class CCI_SimpleRadiosSensor : public CVirtualTableSensor {
 public:
  /** One radio. */
  struct SInterface {
    std::string Id; /**< of its entity */
    std::vector<CByteArray> Messages; /**< received in the last step */

    typedef std::vector<SInterface> TVector;

    SInterface() = default;
    explicit SInterface(const std::string& id) : Id(id) {}
  };

  /** One interface for each radio, in order. */
  const SInterface::TVector& GetInterfaces() const { return m_vecInterfaces; }

  std::vector<SColumn> GetReadingColumns() const override;
  void CopyReadings(Real* numbers, std::size_t count) const override;

 protected:
  SInterface::TVector m_vecInterfaces;

 private:
  const char* GetLuaName() const override { return "simple_radios"; }
  /** robot.simple_radios.<id>.recv[i]: the tables sent by Lua robots; other messages are omitted */
  void WriteReadings(CLuaTable& table) const override;
};

}  // namespace argos

#endif
