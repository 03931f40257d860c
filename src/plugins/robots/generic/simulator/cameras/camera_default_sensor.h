#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERAS_CAMERA_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERAS_CAMERA_DEFAULT_SENSOR_H

#include <argos3/core/simulator/sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor.h>
#include <argos3/plugins/robots/generic/simulator/camera_sensor_algorithm.h>
#include <argos3/plugins/robots/generic/simulator/pinhole_camera.h>

#include <memory>
#include <string>
#include <vector>

namespace argos {

class CControllableEntity;
class CEmbodiedEntity;

/** Any number of pinhole cameras on any robot; see the manual in the source. */
class CCameraDefaultSensor : public CSimulatedSensor, public CCI_CameraSensor {
 public:
  /** @throws CARGoSException unless the robot has a "body". */
  void SetRobot(CComposableEntity& robot) override;
  /**
   * Reads `show_frustum` and the children `<camera>`, each with its algorithms.
   * @throws CARGoSException if a value is missing or out of range, two cameras have the same id,
   * or an algorithm is unknown.
   */
  void Init(TConfigurationNode& tree) override;
  void Enable() override;
  void Disable() override;
  void Update() override;
  void Reset() override;

 private:
  struct SCamera {
    CPinholeCamera Camera;
    std::vector<std::unique_ptr<CCameraSensorSimulatedAlgorithm>> Algorithms;
  };

  void AddCamera(TConfigurationNode& tree);
  std::unique_ptr<CCameraSensorSimulatedAlgorithm> MakeAlgorithm(TConfigurationNode& tree,
                                                                 const std::string& camera);
  void ShowFrustum(const CPinholeCamera& camera) const;

  CComposableEntity* m_robot = nullptr;
  CEmbodiedEntity* m_body = nullptr;
  CControllableEntity* m_controller = nullptr;
  bool m_showFrustum = false;
  std::vector<SCamera> m_cameras;  // same order as m_vecInterfaces
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/space/space.h>
#endif

#endif
