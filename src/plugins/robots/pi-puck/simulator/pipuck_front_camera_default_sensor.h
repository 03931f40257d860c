#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_FRONT_CAMERA_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_FRONT_CAMERA_DEFAULT_SENSOR_H

#include <argos3/core/simulator/physics_engine/physics_model.h>
#include <argos3/core/simulator/sensor.h>
#include <argos3/core/utility/datatypes/color.h>
#include <argos3/plugins/robots/generic/simulator/entities_in_sight.h>
#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_front_camera_sensor.h>

#include <utility>
#include <vector>

namespace argos {

class CControllableEntity;
class CDirectionalLEDEntity;
class CDirectionalLEDMedium;
class CTagEntity;
class CTagMedium;

/** Finds the tags and the directional LEDs in front of a Pi-Puck. */
class CPiPuckFrontCameraDefaultSensor : public CSimulatedSensor,
                                        public CCI_PiPuckFrontCameraSensor {
 public:
  /** @throws CARGoSException if the robot is no Pi-Puck. */
  void SetRobot(CComposableEntity& robot) override;
  /**
   * Also reads `tag_medium`, `directional_led_medium`, `show_frustum`, `show_tag_rays` and
   * `show_led_rays`.
   * @throws CARGoSException if a medium is unknown.
   */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  void Reset() override;
  /** Also forgets what the camera has seen. */
  void Disable() override;

  ELedState DetectLed(const CVector3& position) const override;
  Real GetTimestamp() const override;
  const STag::TVector& GetTags() const override { return m_tags; }

 private:
  static constexpr size_t kTagPoints = 5;  // the centre and the corners

  CVector3 ToCamera(const CVector3& point) const;
  /** @return false if a point in the frame of the camera, m, is not in the image. */
  bool Project(const CVector3& point, CVector2& pixel) const;
  /** The corners of the view, m, world frame: near, then far. */
  std::vector<CVector3> ComputeCorners() const;
  CViewVolume ComputeVolume() const;
  void FindTags(const CViewVolume& view);
  void FindLEDs(const CViewVolume& view);
  void ShowFrustum() const;

  CControllableEntity* m_robot = nullptr;
  const SAnchor* m_anchor = nullptr;  // holds the camera
  CTagMedium* m_tagMedium = nullptr;
  CDirectionalLEDMedium* m_ledMedium = nullptr;
  bool m_showsFrustum = false;
  bool m_showsTagRays = false;
  bool m_showsLEDRays = false;
  UInt32 m_extraTicks = 1;  // lead of the camera's clock over the experiment's
  CEntitiesInSight<CTagEntity, kTagPoints> m_tagsInSight;
  CEntitiesInSight<CDirectionalLEDEntity> m_ledsInSight;
  // data of the current tick
  CVector3 m_position;  // camera, m, world frame
  CQuaternion m_orientation;  // world frame
  STag::TVector m_tags;
  std::vector<std::pair<CVector3, CColor>> m_leds;  // places in the frame of the camera, m
};

}  // namespace argos

#endif
