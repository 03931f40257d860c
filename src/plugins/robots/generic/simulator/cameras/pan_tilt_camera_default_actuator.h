#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERAS_PAN_TILT_CAMERA_DEFAULT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERAS_PAN_TILT_CAMERA_DEFAULT_ACTUATOR_H

#include <argos3/core/simulator/actuator.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/plugins/robots/generic/control_interface/ci_pan_tilt_camera_actuator.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>

namespace argos {

class CPerspectiveCameraEquippedEntity;

/** Turns the view of a robot's perspective camera; see its long description. */
class CPanTiltCameraDefaultActuator : public CSimulatedActuator, public CCI_PanTiltCameraActuator {
 public:
  /** @throws CARGoSException unless the robot has a "perspective_camera". */
  void SetRobot(CComposableEntity& robot) override;
  /**
   * Reads `pan_range`, `tilt_range`, `max_speed` and `<noise>`.
   * @throws CARGoSException if a value is out of range.
   */
  void Init(TConfigurationNode& tree) override;
  /** Angles beyond the limits are cut to them. @throws CARGoSException if they are not finite. */
  void SetPan(const CRadians& pan) override;
  void SetTilt(const CRadians& tilt) override;
  void Update() override;
  /** Looks straight out of the mount, at once. */
  void Reset() override;

 private:
  // one of the two axes
  struct SAxis {
    const char* Name;
    CRange<CRadians> Limits;
    CRadians Target;
  };

  static void ReadLimits(TConfigurationNode& tree, const std::string& attribute,
                         const CDegrees& utmost, SAxis& axis);
  void SetTarget(size_t quantity, SAxis& axis, const CRadians& angle);
  CRadians Approach(const CRadians& current, const CRadians& target) const;

  CPerspectiveCameraEquippedEntity* m_camera = nullptr;  // of the robot
  CControllableEntity* m_robot = nullptr;
  SAxis m_pan = {"pan", {}, CRadians()};
  SAxis m_tilt = {"tilt", {}, CRadians()};
  CRadians m_maxStep;  // in one tick; 0: at once
  CDeviceNoise m_noise;
};

}  // namespace argos

#endif
