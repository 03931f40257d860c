#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERAS_CAMERA_SENSOR_ALGORITHM_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERAS_CAMERA_SENSOR_ALGORITHM_H

#include <argos3/core/utility/configuration/base_configurable_resource.h>
#include <argos3/core/utility/plugins/factory.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_algorithm.h>

#include <string>

namespace argos {

class CComposableEntity;
class CPinholeCamera;

/**
 * The simulated side of an algorithm that looks at the pictures of a camera; a concrete one also
 * derives from its CCI_CameraSensor...Algorithm, and is registered under the tag of its element.
 *
 * Update() may read the space, and write only what is its own: robots sense in parallel, without
 * locks. It must not allocate once settled.
 */
class CCameraSensorSimulatedAlgorithm : public CBaseConfigurableResource {
 public:
  /** Called once, before Init(). @param camera  the id of the camera. */
  virtual void SetCamera(CComposableEntity& robot, const std::string& camera) = 0;
  void Reset() override {}
  void Destroy() override {}
  /** Called in every tick in which the sensor is enabled. */
  virtual void Update(const CPinholeCamera& camera) = 0;
  /** The same object, as the controller sees it. */
  virtual CCI_CameraSensorAlgorithm& GetCIAlgorithm() = 0;
};

}  // namespace argos

#define REGISTER_CAMERA_SENSOR_ALGORITHM(CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION, \
                                         LONG_DESCRIPTION, STATUS)                             \
  REGISTER_SYMBOL(CCameraSensorSimulatedAlgorithm, CLASSNAME, LABEL, AUTHOR, VERSION,          \
                  BRIEF_DESCRIPTION, LONG_DESCRIPTION, STATUS)

#endif
