#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_PHEROMONE_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_PHEROMONE_SENSOR_H

#include <argos3/core/control_interface/print_readings.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

#include <ostream>
#include <string>
#include <vector>

namespace argos {

/** Reads concentrations of substances on the ground. */
class CCI_PheromoneSensor : public CTableSensor {
 public:
  /** The reading at one point. */
  struct SReading {
    Real Value = 0.0; /**< concentration, amount per m^2 */
    CVector2 Offset; /**< of the point from the robot's centre, in the robot's frame, cm */

    template <int = 0>
    friend std::ostream& operator<<(std::ostream& stream, const SReading& reading) {
      return PrintReading(stream, "Value", reading.Value, "Offset", reading.Offset);
    }
    template <int = 0>
    friend std::ostream& operator<<(std::ostream& stream, const std::vector<SReading>& readings) {
      return PrintReadings(stream, readings);
    }
  };
  typedef std::vector<SReading> TReadings;

  /** One substance. */
  struct SInterface {
    std::string Layer; /**< its id */
    TReadings Readings; /**< at each point, in the order of the experiment file */

    typedef std::vector<SInterface> TVector;
  };

  /** One interface for each layer, in order. */
  const SInterface::TVector& GetInterfaces() const { return m_vecInterfaces; }
  /** @return the readings of the first layer. */
  const TReadings& GetReadings() const { return m_vecInterfaces.front().Readings; }
  /**
   * @return the readings of a layer, valid as long as the sensor; controllers look it up once.
   * @throws CARGoSException if the layer is unknown; the text lists the layers.
   */
  const TReadings& GetReadings(const std::string& layer) const;

  std::vector<SColumn> GetReadingColumns() const override;
  void CopyReadings(Real* numbers, std::size_t count) const override;

 protected:
  SInterface::TVector m_vecInterfaces;

 private:
  const char* GetLuaName() const override { return "pheromone"; }
  /** robot.pheromone.<layer>[i] = { value, offset } */
  void WriteReadings(CLuaTable& table) const override;
};

}  // namespace argos

#endif
