#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERAS_CAMERA_SENSOR_ALGORITHM_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERAS_CAMERA_SENSOR_ALGORITHM_H

#include <argos3/core/utility/configuration/base_configurable_resource.h>
#include <argos3/core/utility/math/ray3.h>
#include <argos3/core/utility/plugins/factory.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_algorithm.h>

#include <string>
#include <utility>
#include <vector>

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

  /** Calls Update() for a camera whose pose is current. */
  void Process(const CPinholeCamera& camera) {
    m_vecCheckedRays.clear();
    m_camera = &camera;
    Update(camera);
  }
  /** The rays of the last Update(), which visualizations show; true: obstructed. */
  const std::vector<std::pair<bool, CRay3>>& GetCheckedRays() const { return m_vecCheckedRays; }

 protected:
  /**
   * In Update(): @return true if the point (m, world frame) is in the image, obstructed or not.
   */
  bool IsPointInsideFrustum(const CVector3& point) const;

  // Update() may append to them; cleared before
  std::vector<std::pair<bool, CRay3>> m_vecCheckedRays;

 private:
  const CPinholeCamera* m_camera = nullptr;  // camera of the current Update()
};

}  // namespace argos

#define REGISTER_CAMERA_SENSOR_ALGORITHM(CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION, \
                                         LONG_DESCRIPTION, STATUS)                             \
  REGISTER_SYMBOL(CCameraSensorSimulatedAlgorithm, CLASSNAME, LABEL, AUTHOR, VERSION,          \
                  BRIEF_DESCRIPTION, LONG_DESCRIPTION, STATUS)

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/utility/math/matrix/transformationmatrix3.h>
#include <argos3/core/utility/math/plane.h>
#endif

#endif
