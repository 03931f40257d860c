#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERAS_CAMERA_DETECTOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERAS_CAMERA_DETECTOR_H

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/plugins/robots/generic/simulator/camera_sensor_algorithm.h>
#include <argos3/plugins/robots/generic/simulator/entities_in_sight.h>
#include <argos3/plugins/robots/generic/simulator/medium_attribute.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>
#include <argos3/plugins/robots/generic/simulator/pinhole_camera.h>

#include <string>

namespace argos {

/**
 * Base of the detectors: finds the entities of a medium that are visible to a camera.
 * @tparam INTERFACE   the control interface.
 * @tparam NUM_POINTS  number of points of an entity that must all be in the image and visible.
 */
template <class INTERFACE, class ENTITY, class MEDIUM, size_t NUM_POINTS>
class CCameraDetector : public CCameraSensorSimulatedAlgorithm, public INTERFACE {
 public:
  void SetCamera(CComposableEntity& robot, const std::string& camera) override {
    m_robot = &robot.GetComponent<CControllableEntity>("controller");
    m_cameraId = camera;
    m_sight.SetRobot(robot);
  }
  /**
   * Reads `medium`, `show_rays` and `<noise>`.
   * @throws CARGoSException if the medium is unknown, or noise is out of range.
   */
  void Init(TConfigurationNode& tree) override {
    m_medium = &ReadMedium<MEDIUM>(tree, m_robot->GetSimulator(), GetMediumKind());
    m_medium->KeepPoints();
    GetNodeAttributeOrDefault(tree, "show_rays", m_showRays, false);
    m_noise.Init(tree, *m_robot, {"x", "y"}, {}, " of camera " + m_cameraId);
  }
  void Reset() override {
    m_noise.Reset();
    ClearReadings();
  }
  CCI_CameraSensorAlgorithm& GetCIAlgorithm() override { return *this; }

 protected:
  /** Kind of the medium, for error messages: "an LED medium". */
  virtual std::string GetMediumKind() const = 0;
  virtual void ClearReadings() { this->m_tReadings.clear(); }

  /**
   * Clears the readings, and calls @p see for every visible entity. The entity's position is the
   * first of its points.
   * @param locate  bool(const ENTITY&, const CVector3& image, SSightPoint* points): false if the
   *                entity cannot be visible to this camera, which sees it displaced by @p image
   * (m); else writes the positions of its other points there. Called only if the first point is in
   * the image of the camera.
   * @param see     void(const ENTITY&, const CVector2* pixels): called in order of creation, with
   * the pixels of the entity's points, including noise.
   */
  template <typename LOCATE, typename SEE>
  void Detect(const CPinholeCamera& camera, LOCATE&& locate, SEE&& see) {
    ClearReadings();
    m_sight.Detect(
        *m_medium, camera.GetPosition(), camera.GetVolume(),
        [&](const ENTITY& entity, SSightPoint* points) {
          const CVector3 displacement = m_sight.FindImage(entity.GetPosition());
          points[0].Position = entity.GetPosition() + displacement;
          bool inImage = camera.Project(points[0].Position, points[0].Pixel) &&
                         locate(entity, displacement, points + 1);
          for (size_t i = 1; inImage && i < NUM_POINTS; ++i) {
            inImage = camera.Project(points[i].Position, points[i].Pixel);
          }
          return inImage;
        },
        [&](const ENTITY& entity, const SSightPoint* points) {
          CVector2 pixels[NUM_POINTS];
          for (size_t i = 0; i < NUM_POINTS; ++i) {
            pixels[i].SetX(m_noise.Apply(0, points[i].Pixel.GetX()));
            pixels[i].SetY(m_noise.Apply(1, points[i].Pixel.GetY()));
          }
          see(entity, pixels);
        },
        m_showRays);
  }

 private:
  CControllableEntity* m_robot = nullptr;
  std::string m_cameraId;
  MEDIUM* m_medium = nullptr;
  bool m_showRays = false;
  CDeviceNoise m_noise;
  CEntitiesInSight<ENTITY, NUM_POINTS> m_sight;
};

}  // namespace argos

#endif
