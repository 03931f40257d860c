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
class CSpace;
struct SGroundSensorLayout;

/** @throws CARGoSException after loading, if there is no floor. @param device  its element. */
void RequireFloor(const CControllableEntity& robot, TConfigurationNode& device);

/**
 * Reads the floor below a robot, for all types of ground sensors.
 *
 * A sensor reads the grey level of the floor straight below it: 0.299 red + 0.587 green + 0.114
 * blue, from 0 (black) to 1 (white). Bodies do not occlude the floor.
 */
class CFloorReader {
 public:
  static constexpr const char* kKind = "ground sensors";

  /**
   * Finds and enables the robot's "ground_sensors".
   * @throws CARGoSException if it has none, or no "controller".
   */
  void SetRobot(CComposableEntity& robot);
  /**
   * Reads `noise_level` and `<noise on="reading">` children.
   * @throws CARGoSException if the level is < 0; after loading, if there is no floor.
   */
  void Init(TConfigurationNode& tree);
  /** Restarts the noise. */
  void Reset() { m_noise.Reset(); }

  /** Before Init(): the sensor reads `noise_level` itself. */
  void LeaveNoiseLevel() { m_readsNoiseLevel = false; }

  size_t GetNumSensors() const;
  /** For sensors whose derived classes find the robot's parts themselves. */
  CGroundSensorEquippedEntity*& AccessSensors() { return m_sensors; }
  void SetSpace(CSpace& space) { m_space = &space; }

  /** @return a view of the current floor. @throws CARGoSException if there is none. */
  class CView;
  CView ViewFloor();
  /**
   * Reads consecutive sensors.
   * @param readings  the Value of each one is written; see CView::Read().
   * @param first     number of the first sensor.
   */
  template <typename READINGS>
  void Read(READINGS& readings, size_t first);

 private:
  CControllableEntity& GetRobot() const;

  CGroundSensorEquippedEntity* m_sensors = nullptr;
  CSpace* m_space = nullptr;
  CDeviceNoise m_noise;
  bool m_readsNoiseLevel = true;
};

/** The floor below the sensors of a robot in one tick. */
class CFloorReader::CView {
 public:
  CView(CFloorReader& reader, const SGroundSensorLayout& layout, CFloorEntity& floor)
      : m_reader(reader), m_layout(layout), m_floor(floor) {}

  /**
   * @param error  is added to the grey level.
   * @return the reading with noise, in [0,1]; 0 or 1 for a black-and-white sensor.
   */
  Real Read(size_t sensor, Real error = 0.0);
  CFloorEntity& GetFloor() const { return m_floor; }

 private:
  CFloorReader& m_reader;
  const SGroundSensorLayout& m_layout;
  CFloorEntity& m_floor;
};

template <typename READINGS>
void CFloorReader::Read(READINGS& readings, size_t first) {
  CView view = ViewFloor();
  for (auto& reading : readings) {
    reading.Value = view.Read(first++);
  }
}

}  // namespace argos

#endif
