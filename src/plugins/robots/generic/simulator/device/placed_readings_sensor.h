#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DEVICE_PLACED_READINGS_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DEVICE_PLACED_READINGS_SENSOR_H

#include <argos3/core/simulator/entity/array_sensor.h>
#include <argos3/core/utility/configuration/argos_configuration.h>

#include <cstddef>

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

/** CArraySensor::ListInputs() of a reader that has such a function. */
template <class READER>
auto ListInputsOf(const READER& reader, std::vector<CArraySensor::SArray>& inputs, int)
    -> decltype(reader.ListInputs(inputs)) {
  reader.ListInputs(inputs);
}
template <class READER>
void ListInputsOf(const READER& /*reader*/, std::vector<CArraySensor::SArray>& /*inputs*/, long) {}

/**
 * Base of sensors whose readings contain their places: everything except Update().
 *
 * @tparam INTERFACE  the control interface: derives from CPlacedSensors.
 * @tparam READER     computes the readings: has SetRobot(), Init(), Reset(), GetNumSensors() and
 *                    kKind.
 */
template <class INTERFACE, class READER>
class CPlacedReadingsSensor : public CArraySensor, public INTERFACE {
 public:
  /** See READER::SetRobot(). @throws CARGoSException if the robot has another number of sensors. */
  void SetRobot(CComposableEntity& robot) override {
    m_reader.SetRobot(robot);
    RequireNumSensors(robot, INTERFACE::kPlaces.Device, READER::kKind, GetNumNeeded(),
                      m_reader.GetNumSensors());
  }
  /** See READER::Init(). */
  void Init(TConfigurationNode& tree) override {
    INTERFACE::Init(tree);
    m_reader.Init(tree);
    this->Enable();
  }
  void Reset() override {
    for (auto& reading : this->m_tReadings) {
      reading.Value = 0.0;
    }
    m_reader.Reset();
  }
  CArraySensor::SArray GetReadingsArray() const override { return ArrayOf(this->m_tReadings); }
  void ListInputs(std::vector<CArraySensor::SArray>& inputs) const override {
    ListInputsOf(m_reader, inputs, 0);
  }
  bool IsShowRays() const { return m_reader.IsShowRays(); }
  /** @param show  true: visualizations show the sensor's rays, from the next tick on. */
  void SetShowRays(bool show) { m_reader.SetShowRays(show); }

 protected:
  /** Number of sensors, of the reader's kind, that the robot must have. */
  virtual size_t GetNumNeeded() const { return INTERFACE::kPlaces.Num; }

  READER m_reader;
};

/**
 * The same for sensors whose readings are numbers, one for each sensor of the robot.
 */
template <class INTERFACE, class READER>
class CPlainReadingsSensor : public CArraySensor, public INTERFACE {
 public:
  /** See READER::SetRobot(). */
  void SetRobot(CComposableEntity& robot) override { m_reader.SetRobot(robot); }
  /** See READER::Init(). */
  void Init(TConfigurationNode& tree) override {
    INTERFACE::Init(tree);
    m_reader.Init(tree);
    ClearReadings();
    this->Enable();
  }
  void Reset() override {
    ClearReadings();
    m_reader.Reset();
  }
  CArraySensor::SArray GetReadingsArray() const override { return ArrayOf(this->m_tReadings); }
  void ListInputs(std::vector<CArraySensor::SArray>& inputs) const override {
    ListInputsOf(m_reader, inputs, 0);
  }
  bool IsShowRays() const { return m_reader.IsShowRays(); }
  /** @param show  true: visualizations show the sensor's rays, from the next tick on. */
  void SetShowRays(bool show) { m_reader.SetShowRays(show); }

 protected:
  READER m_reader;

 private:
  void ClearReadings() { this->m_tReadings.assign(m_reader.GetNumSensors(), 0.0); }
};

}  // namespace argos

#endif
