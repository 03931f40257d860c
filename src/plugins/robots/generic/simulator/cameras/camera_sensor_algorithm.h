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
 * The simulated side of an algorithm that processes the images of a camera; a concrete algorithm
 * also derives from its CCI_CameraSensor...Algorithm, and is registered under its XML element.
 *
 * Update() may read the space, but writes only its own data: robots sense in parallel, without
 * locks. It must not allocate memory in a settled tick.
 */
class CCameraSensorSimulatedAlgorithm : public CBaseConfigurableResource {
 public:
  /** Called once, before Init(). @param camera  the id of the camera. */
  virtual void SetCamera(CComposableEntity& robot, const std::string& camera) = 0;
  void Reset() override {}
  void Destroy() override {}
  /** Called in every tick in which the sensor is enabled. */
  virtual void Update(const CPinholeCamera& camera) = 0;
  /** @return this object as the interface for controllers. */
  virtual CCI_CameraSensorAlgorithm& GetCIAlgorithm() = 0;
};

}  // namespace argos

#define REGISTER_CAMERA_SENSOR_ALGORITHM(CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION, \
                                         LONG_DESCRIPTION, STATUS)                             \
  REGISTER_SYMBOL(CCameraSensorSimulatedAlgorithm, CLASSNAME, LABEL, AUTHOR, VERSION,          \
                  BRIEF_DESCRIPTION, LONG_DESCRIPTION, STATUS)

#endif
