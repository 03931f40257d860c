#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RADIO_RFID_MEDIUM_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RADIO_RFID_MEDIUM_SENSOR_H

#include <argos3/core/simulator/sensor.h>
#include <argos3/core/utility/datatypes/spare_elements.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/generic/control_interface/ci_rfid_sensor.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>
#include <argos3/plugins/robots/generic/simulator/rfid_antenna.h>

#include <memory>
#include <vector>

namespace argos {

/** Reads the tags that a medium finds near the robot. */
class CRFIDMediumSensor : public CSimulatedSensor, public CCI_RFIDSensor {
 public:
  void SetRobot(CComposableEntity& robot) override;
  /** Reads what CRFIDAntenna::Init() does, `miss_prob` and `<noise>`. @throws CARGoSException. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  /** No readings; noise starts over. */
  void Reset() override;

 private:
  enum EQuantity : UInt8 { DISTANCE, ANGLE };

  void Fill(SReading& reading, const CRFIDTagEntity& tag);
  void MakeStream();

  CRFIDAntenna m_antenna;
  Real m_missProbability = 0.0;
  std::unique_ptr<CRandomStream> m_stream;  // only if tags may be missed
  CDeviceNoise m_noise;  // on EQuantity
  std::vector<CRFIDMedium::SFound> m_found;
  CSpareElements<SReading> m_spare;
};

}  // namespace argos

#endif
