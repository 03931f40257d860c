#include <argos3/plugins/robots/generic/simulator/camera_sensor_algorithm.h>

#include <argos3/plugins/robots/generic/simulator/pinhole_camera.h>

namespace argos {

bool CCameraSensorSimulatedAlgorithm::IsPointInsideFrustum(const CVector3& point) const {
  CVector2 pixel;
  return m_camera->Project(point, pixel);
}

}  // namespace argos
