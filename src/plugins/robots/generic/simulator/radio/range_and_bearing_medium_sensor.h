#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RADIO_RANGE_AND_BEARING_MEDIUM_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RADIO_RANGE_AND_BEARING_MEDIUM_SENSOR_H

#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>
#include <argos3/plugins/robots/generic/simulator/noisy_sensor.h>
#include <argos3/plugins/simulator/entities/spare_elements.h>

#include <memory>

namespace argos {

class CRABEquippedEntity;
class CRABMedium;

/**
 * Reads the messages that the robot's range-and-bearing device receives through its medium. A
 * derived class may set the protected members itself in its SetRobot() and Init().
 */
class CRangeAndBearingMediumSensor : public CNoisySensor<CCI_RangeAndBearingSensor> {
 public:
  CRangeAndBearingMediumSensor();

  void Update() override;

  bool IsShowRays() const { return m_bShowRays; }
  /** @param show  true: visualizations show the sensor's rays, from the next tick on. */
  void SetShowRays(bool show) { m_bShowRays = show; }

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
  /** @param toReceiver  rotates from the world frame into the frame of the robot's device. */
  void ReadFrom(const CRABEquippedEntity& sender, const CQuaternion& toReceiver, SPacket& packet);
  void AddNoise(SPacket& packet);
  CVector3 DrawError();
  CRandomStream& GetStream();

  CRABMedium* m_medium = nullptr;
  std::unique_ptr<CRandomStream> m_stream;  // null without noise and loss
  CSpareElements<SPacket> m_spare;

 protected:
  CRABEquippedEntity* m_pcRangeAndBearingEquippedEntity = nullptr;
  CControllableEntity*& m_pcControllableEntity;
  CSpace& m_cSpace;
  bool m_bShowRays = false;
  Real m_fDistanceNoiseStdDev = 0.0;  // m
  Real m_fPacketDropProb = 0.0;
  CRandom::CRNG* m_pcRNG = nullptr;  // set for derived classes if the file has noise or loss
};

}  // namespace argos

#endif
