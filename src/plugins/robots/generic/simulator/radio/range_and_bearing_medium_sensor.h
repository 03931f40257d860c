#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RADIO_RANGE_AND_BEARING_MEDIUM_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RADIO_RANGE_AND_BEARING_MEDIUM_SENSOR_H

#include <argos3/core/utility/datatypes/spare_elements.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>
#include <argos3/plugins/robots/generic/simulator/noisy_sensor.h>

#include <memory>

namespace argos {

class CRABEquippedEntity;
class CRABMedium;

/** Reads the messages that the robot's range-and-bearing device receives through its medium. */
class CRangeAndBearingMediumSensor : public CNoisySensor<CCI_RangeAndBearingSensor> {
 public:
  void Update() override;

 private:
  enum EQuantity : UInt8 { RANGE, HORIZONTAL_BEARING, VERTICAL_BEARING };

  void FindParts(CComposableEntity& robot) override;
  /**
   * Also reads `medium`, `show_rays`, `noise_std_dev`, `packet_drop_prob`.
   * @throws CARGoSException if a value is invalid.
   */
  void Configure(TConfigurationNode& tree) override;
  /** Clears the packets and restarts the noise. */
  void ResetReading() override;
  void ReadFrom(const CRABEquippedEntity& sender, SPacket& packet);
  void AddNoise(SPacket& packet);
  CVector3 DrawError();

  CRABEquippedEntity* m_rab = nullptr;  // of the robot
  CRABMedium* m_medium = nullptr;
  bool m_showRays = false;
  Real m_noiseDeviation = 0.0;  // m
  Real m_dropProbability = 0.0;
  std::unique_ptr<CRandomStream> m_stream;  // only with noise or loss
  CSpareElements<SPacket> m_spare;
};

}  // namespace argos

#endif
