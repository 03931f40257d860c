#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_GROUND_FLOOR_READER_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_GROUND_FLOOR_READER_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>

#include <string>

namespace argos {

class CComposableEntity;
class CControllableEntity;
class CFloorEntity;
class CGroundSensorEquippedEntity;
struct SGroundSensorLayout;

/**
 * Looks at the floor below a robot: what all ground sensors have in common.
 *
 * A sensor sees the colour of the floor straight below where it is: 0.299 red + 0.587 green + 0.114
 * blue, from 0 (black) to 1 (white). Bodies do not hide the floor.
 */
class CFloorReader {
 public:
  /**
   * Finds and enables the robot's "ground_sensors".
   * @throws CARGoSException if it has none, or no "controller".
   */
  void SetRobot(CComposableEntity& robot);
  /**
   * Reads `noise_level` and `<noise on="reading">` children.
   * @throws CARGoSException if the level is < 0; when loading is over, if there is no floor.
   */
  void Init(TConfigurationNode& tree);
  /** Noise starts over. */
  void Reset() { m_noise.Reset(); }

  size_t GetNumSensors() const;
  /** @throws CARGoSException that names @p device if the robot does not have so many sensors. */
  void RequireNumSensors(size_t num, const std::string& device) const;

  /** Looks at the floor as it is now. @throws CARGoSException if there is none. */
  class CView;
  CView Look();
  /**
   * Takes the readings of sensors that follow each other.
   * @param readings  each with a Value that is written; see CView::Read().
   * @param first     number of the first sensor.
   */
  template <typename READINGS>
  void Read(READINGS& readings, size_t first);

 private:
  CGroundSensorEquippedEntity* m_sensors = nullptr;  // of the robot
  CControllableEntity* m_robot = nullptr;
  CDeviceNoise m_noise;
};

/** What the sensors of a robot see in one tick. */
class CFloorReader::CView {
 public:
  CView(CFloorReader& reader, const SGroundSensorLayout& layout, CFloorEntity& floor)
      : m_reader(reader), m_layout(layout), m_floor(floor) {}

  /** With noise: in [0,1], or 0 or 1 if the sensor knows only black and white. */
  Real Read(size_t sensor);

 private:
  CFloorReader& m_reader;
  const SGroundSensorLayout& m_layout;
  CFloorEntity& m_floor;
};

template <typename READINGS>
void CFloorReader::Read(READINGS& readings, size_t first) {
  CView view = Look();
  for (auto& reading : readings) {
    reading.Value = view.Read(first++);
  }
}

}  // namespace argos

#endif
