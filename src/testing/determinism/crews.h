#ifndef ARGOS3_TESTING_DETERMINISM_CREWS_H
#define ARGOS3_TESTING_DETERMINISM_CREWS_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/testing/support/experiment.h>

namespace argos {

class CCI_ColoredBlobPerspectiveCameraSensor;
class CCI_DifferentialSteeringActuator;
class CCI_EyeBotLightSensor;
class CCI_EyeBotProximitySensor;
class CCI_FootBotGripperActuator;
class CCI_FootBotTurretActuator;
class CCI_FootBotTurretEncoderSensor;
class CCI_PositioningSensor;
class CCI_QuadRotorPositionActuator;
class CCI_QuadRotorSpeedActuator;

/** A controller that keeps a digest of all readings since the start. */
class CRecorder : public CCI_Controller {
 public:
  void Reset() override;
  UInt64 GetRead() const { return m_read.GetValue(); }

 protected:
  /** Adds a reading to the digest. @return the reading. */
  Real Read(Real reading);
  UInt32 GetStep() const { return m_step; }
  void CountStep() { ++m_step; }

 private:
  CDigest m_read;
  UInt32 m_step = 0;
};

/** "holder": grips, releases, turns its turret and drives, depending on the turret's rotation. */
class CHolder : public CRecorder {
 public:
  void Init(TConfigurationNode& params) override;
  void ControlStep() override;

 private:
  CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  CCI_FootBotGripperActuator* m_gripper = nullptr;
  CCI_FootBotTurretActuator* m_turret = nullptr;
  const CCI_FootBotTurretEncoderSensor* m_encoder = nullptr;
};

/** "flyer": flies by position or speed orders that depend on its sensors. */
class CFlyer : public CRecorder {
 public:
  void Init(TConfigurationNode& params) override;
  void ControlStep() override;

 private:
  CCI_QuadRotorPositionActuator* m_places = nullptr;  // null if it flies by speed orders
  CCI_QuadRotorSpeedActuator* m_speeds = nullptr;  // null if it flies by position orders
  const CCI_EyeBotProximitySensor* m_proximity = nullptr;
  const CCI_EyeBotLightSensor* m_light = nullptr;
  const CCI_PositioningSensor* m_pose = nullptr;
  const CCI_ColoredBlobPerspectiveCameraSensor* m_camera = nullptr;
};

/** Pairs of foot-bots with a load between them; with all kinds of noise if @p noisy. */
SExperiment Holders(UInt32 pairs, bool noisy);
/**
 * Eye-bots above lamps; half of them fly by position orders. With all kinds of noise if @p noisy.
 */
SExperiment Flyers(UInt32 robots, bool noisy);

}  // namespace argos

#endif
