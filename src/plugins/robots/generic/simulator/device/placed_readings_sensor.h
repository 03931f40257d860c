#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DEVICE_PLACED_READINGS_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DEVICE_PLACED_READINGS_SENSOR_H

#include <argos3/core/simulator/entity/sensor.h>
#include <argos3/core/utility/configuration/argos_configuration.h>

#include <cstddef>
#include <vector>

namespace argos {

class CComposableEntity;

/**
 * Checks the number of sensors of a robot.
 * @param device  label of the device, for the message.
 * @param kind    of the sensors, such as "light sensors".
 * @throws CARGoSException unless @p num is @p needed.
 */
void RequireNumSensors(const CComposableEntity& robot, const char* device, const char* kind,
                       size_t needed, size_t num);

/** ListMemory() of a reader that has such a function. */
template <class READER>
auto ListMemoryOf(const READER& reader, std::vector<SMemory>& memory, int)
    -> decltype(reader.ListMemory(memory)) {
  reader.ListMemory(memory);
}
template <class READER>
void ListMemoryOf(const READER& /*reader*/, std::vector<SMemory>& /*memory*/, long) {}

/**
 * Base of sensors with an array of readings.
 *
 * @tparam INTERFACE  the control interface, with m_tReadings.
 * @tparam READER     computes the readings: has SetRobot(), Init(), Reset() and GetNumSensors().
 */
template <class INTERFACE, class READER>
class CReadingsSensor : public CSimulatedSensor, public INTERFACE {
 public:
  void ListMemory(std::vector<SMemory>& memory) const override {
    const auto& readings = this->m_tReadings;
    memory.push_back({readings.data(), readings.size() * sizeof(*readings.data())});
    ListMemoryOf(m_reader, memory, 0);
  }
  bool IsShowRays() const { return m_reader.IsShowRays(); }
  /** @param show  true: visualizations show the sensor's rays, from the next tick on. */
  void SetShowRays(bool show) { m_reader.SetShowRays(show); }

 protected:
  READER m_reader;
};

/**
 * Base of sensors whose readings contain their places: everything except Update().
 *
 * @tparam INTERFACE  derives from CPlacedSensors.
 * @tparam READER     also has kKind.
 */
template <class INTERFACE, class READER>
class CPlacedReadingsSensor : public CReadingsSensor<INTERFACE, READER> {
 public:
  /** See READER::SetRobot(). @throws CARGoSException if the robot has another number of sensors. */
  void SetRobot(CComposableEntity& robot) override {
    this->m_reader.SetRobot(robot);
    RequireNumSensors(robot, INTERFACE::kPlaces.Device, READER::kKind, GetNumNeeded(),
                      this->m_reader.GetNumSensors());
  }
  /** See READER::Init(). */
  void Init(TConfigurationNode& tree) override {
    INTERFACE::Init(tree);
    this->m_reader.Init(tree);
    this->Enable();
  }
  void Reset() override {
    for (auto& reading : this->m_tReadings) {
      reading.Value = 0.0;
    }
    this->m_reader.Reset();
  }

 protected:
  /** Number of sensors, of the reader's kind, that the robot must have. */
  virtual size_t GetNumNeeded() const { return INTERFACE::kPlaces.Num; }
};

/** The same for sensors whose readings are numbers, one for each sensor of the robot. */
template <class INTERFACE, class READER>
class CPlainReadingsSensor : public CReadingsSensor<INTERFACE, READER> {
 public:
  /** See READER::SetRobot(). */
  void SetRobot(CComposableEntity& robot) override { this->m_reader.SetRobot(robot); }
  /** See READER::Init(). */
  void Init(TConfigurationNode& tree) override {
    INTERFACE::Init(tree);
    this->m_reader.Init(tree);
    ClearReadings();
    this->Enable();
  }
  void Reset() override {
    ClearReadings();
    this->m_reader.Reset();
  }

 private:
  void ClearReadings() { this->m_tReadings.assign(this->m_reader.GetNumSensors(), 0.0); }
};

}  // namespace argos

#endif
