#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERAS_COLORED_BLOB_CAMERA_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERAS_COLORED_BLOB_CAMERA_H

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/sensor.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/generic/simulator/entities_in_sight.h>
#include <argos3/plugins/robots/generic/simulator/medium_attribute.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>
#include <argos3/plugins/simulator/entities/led_entity.h>
#include <argos3/plugins/simulator/media/led_medium.h>

#include <memory>
#include <string>
#include <vector>

namespace argos {

/**
 * Base of the cameras that list coloured blobs: everything except the geometry.
 *
 * A derived class calls FindCamera() in SetRobot() and InitCamera() in Init(); its Update() adds to
 * m_blobs between StartImage() and EndImage().
 * @tparam INTERFACE  the control interface: has SBlob and m_sReadings.
 * @tparam CAMERA     the component of the robot.
 */
template <class INTERFACE, class CAMERA>
class CColoredBlobCamera : public CSimulatedSensor, public INTERFACE {
 public:
  void Enable() override {
    INTERFACE::Enable();
    m_camera->Enable();
  }
  void Disable() override {
    INTERFACE::Disable();
    m_camera->Disable();
  }
  void Reset() override {
    this->m_sReadings.BlobList.clear();
    this->m_sReadings.Counter = 0;
    m_noise.Reset();
    MakeShifts();
  }

  bool IsShowRays() const { return m_showRays; }
  /** @param show  true: visualizations show the sensor's rays, from the next tick on. */
  void SetShowRays(bool show) { m_showRays = show; }

 protected:
  /** @param type of the component. @throws CARGoSException if the robot does not have it. */
  void FindCamera(CComposableEntity& robot, const char* type) {
    m_camera = &robot.GetComponent<CAMERA>(type);
    m_robot = &robot.GetComponent<CControllableEntity>("controller");
    m_sight.SetRobot(robot);
  }
  /**
   * Reads `medium`, `show_rays`, `noise_std_dev` and `<noise>`.
   * @param quantities    that `<noise>` may be on.
   * @param shiftPurpose  name of the random stream for `noise_std_dev`; a literal.
   * @throws CARGoSException if the LED medium is unknown, or noise is out of range.
   */
  void InitCamera(TConfigurationNode& tree, const std::vector<std::string>& quantities,
                  const char* shiftPurpose) {
    INTERFACE::Init(tree);
    INTERFACE::Disable();  // the controller may enable it
    m_medium = &ReadMedium<CLEDMedium>(tree, m_robot->GetSimulator(), "an LED medium");
    m_medium->KeepPoints();
    GetNodeAttributeOrDefault(tree, "show_rays", m_showRays, false);
    GetNodeAttributeOrDefault(tree, "noise_std_dev", m_noiseStdDev, 0.0);
    RequireNotNegative(m_noiseStdDev, OwnerOf(tree), "attribute \"noise_std_dev\"");
    m_noise.Init(tree, *m_robot, quantities);
    m_shiftPurpose = shiftPurpose;
    MakeShifts();
  }

  void StartImage() {
    ++this->m_sReadings.Counter;
    m_blobs.clear();
  }
  /** Lists the blobs; m_blobs must not be reallocated afterwards. */
  void EndImage() {
    this->m_sReadings.BlobList.clear();
    for (auto& blob : m_blobs) {
      this->m_sReadings.BlobList.push_back(&blob);
    }
  }

  CAMERA* m_camera = nullptr;
  CLEDMedium* m_medium = nullptr;
  bool m_showRays = false;
  Real m_noiseStdDev = 0.0;  // its unit depends on the derived class
  std::unique_ptr<CRandomStream> m_shifts;  // null without noise_std_dev
  CDeviceNoise m_noise;
  CEntitiesInSight<CLEDEntity> m_sight;
  std::vector<typename INTERFACE::SBlob> m_blobs;  // the list in the readings points to them

 private:
  void MakeShifts() {
    if (m_noiseStdDev > 0.0) {
      m_shifts = std::make_unique<CRandomStream>(m_robot->GetSimulator().GetRandomSeed(), "argos",
                                                 m_robot->GetRootEntity().GetId(), m_shiftPurpose);
    }
  }

  CControllableEntity* m_robot = nullptr;
  const char* m_shiftPurpose = "";
};

}  // namespace argos

#endif
