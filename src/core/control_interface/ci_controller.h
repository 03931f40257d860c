#ifndef ARGOS3_CORE_CONTROL_INTERFACE_CI_CONTROLLER_H
#define ARGOS3_CORE_CONTROL_INTERFACE_CI_CONTROLLER_H

#include <argos3/core/config.h>
#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/control_interface/on_error.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/configuration/base_configurable_resource.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/memory/object_slabs.h>
#include <argos3/core/utility/plugins/factory.h>
#include <argos3/core/utility/text/string_utilities.h>

// existing controllers use these names, the C functions unqualified
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace argos {

/**
 * Base class of every controller, on the real robot and in the simulator.
 *
 * Lifetime: constructor; devices are added; Init(); ControlStep() once a tick, after the update of
 * the sensors and before that of the actuators; Reset() when the experiment is restarted (not
 * before the first start); Destroy(); destructor. Controllers of different robots step in parallel:
 * ControlStep() must not write to data that they share.
 */
class CCI_Controller : public CBaseConfigurableResource, public CSlabObject {
 public:
  CCI_Controller() = default;
  /** A copy uses the devices of the original, which must outlive it, and owns none. */
  CCI_Controller(const CCI_Controller& other);
  /** A controller keeps its devices and its id; one that has none uses those of the other. */
  CCI_Controller& operator=(const CCI_Controller& other);

  /** Deletes the devices, but not those of the original of a copy. */
  ~CCI_Controller() override;

  /**
   * Called once, before the first tick. The robot has its id and its devices: look them up here,
   * with GetActuator() and GetSensor(), and read parameters. Sensors have not measured yet.
   * @param node  the <params> element.
   */
  void Init(TConfigurationNode& node) override;
  /**
   * Called in every tick, after bodies have moved and sensors have measured: read the sensors, and
   * set the actuators, which act in the next tick. Robots are controlled by several threads: only
   * this robot may be changed. An exception ends the run, or stops the robot, as ChooseOnError()
   * says.
   */
  virtual void ControlStep();
  /** Called when the experiment is reset: restores the state that Init() left. */
  void Reset() override;
  /** Called once, at the end or when the robot is removed. */
  void Destroy() override;

  /**
   * What follows when this robot's code throws in a run.
   * @param configured  by the controller's element in <controllers>, or else by <experiment>.
   */
  virtual EOnError ChooseOnError(std::optional<EOnError> configured) const {
    return configured.value_or(EOnError::EndRun);
  }

  /** The id of the robot. */
  const std::string& GetId() const { return m_strId; }
  void SetId(const std::string& id) { m_strId = id; }

  /**
   * The robot's actuator of a type; owned by the controller.
   * @param type  the tag in the <actuators> section, such as "differential_steering".
   * @throws CARGoSException if the section has no such tag, or if the actuator is not an
   *   ACTUATOR_IMPL; the text gives the robot and its actuators.
   */
  template <typename ACTUATOR_IMPL>
  ACTUATOR_IMPL* GetActuator(const std::string& type) {
    return GetDevice<ACTUATOR_IMPL>(m_mapActuators, type, "actuator");
  }

  /** The robot's sensor of a type, from the <sensors> section; see GetActuator(). */
  template <typename SENSOR_IMPL>
  SENSOR_IMPL* GetSensor(const std::string& type) {
    return GetDevice<SENSOR_IMPL>(m_mapSensors, type, "sensor");
  }

  bool HasActuator(const std::string& type) const { return m_mapActuators.count(type) > 0; }
  bool HasSensor(const std::string& type) const { return m_mapSensors.count(type) > 0; }

  CCI_Actuator::TMap& GetAllActuators() { return m_mapActuators; }
  CCI_Sensor::TMap& GetAllSensors() { return m_mapSensors; }

  /**
   * Keeps a number of this robot, which tables and recordings write as the field `value:NAME`. It
   * lasts until the next call, or until Reset(). A call takes some nanoseconds for the first names.
   * @param name  letters, digits and '_', beginning with a letter.
   * @throws CARGoSException if it is another name.
   */
  void RecordValue(std::string_view name, Real value);
  /** @return NaN if there is none of that name. */
  Real GetRecordedValue(std::string_view name) const;
  /** In the order of their first records. */
  const std::vector<std::pair<std::string, Real>>& GetRecordedValues() const {
    return m_recordedValues;
  }
  /** For the simulator, before Reset(). */
  void ForgetRecordedValues() { m_recordedValues.clear(); }

  /** Adds a device, owned by the controller; deletes a previous device of this type. */
  void AddActuator(const std::string& type, CCI_Actuator* actuator);
  void AddSensor(const std::string& type, CCI_Sensor* sensor);

 protected:
  CCI_Actuator::TMap m_mapActuators;
  CCI_Sensor::TMap m_mapSensors;
  std::string m_strId;

 private:
  void CheckOwnsDevices() const;
  template <typename DEVICE_IMPL, typename MAP>
  DEVICE_IMPL* GetDevice(const MAP& devices, const std::string& type, const char* kind) const {
    const auto device = devices.find(type);
    if (device == devices.end()) {
      std::vector<std::string> types;
      for (const auto& known : devices) {
        types.push_back(known.first);
      }
      ThrowDeviceMissing(kind, type, types);
    }
    auto* found = dynamic_cast<DEVICE_IMPL*>(device->second);
    if (found == nullptr) {
      const auto& actual = *device->second;
      ThrowDeviceOfOtherType(kind, type, typeid(actual), typeid(DEVICE_IMPL));
    }
    return found;
  }

  [[noreturn]] void ThrowDeviceMissing(const std::string& kind, const std::string& type,
                                       const std::vector<std::string>& types) const;
  [[noreturn]] void ThrowDeviceOfOtherType(const std::string& kind, const std::string& type,
                                           const std::type_info& found,
                                           const std::type_info& expected) const;

  std::vector<std::pair<std::string, Real>> m_recordedValues;
  bool m_isCopy = false;  // true: the devices belong to another controller
};

}  // namespace argos

/**
 * Registers a controller under a label, the tag of its element in <controllers>. Use it once per
 * controller, in its source file, with or without a semicolon.
 */
#ifdef ARGOS_DYNAMIC_LIBRARY_LOADING
#define REGISTER_CONTROLLER(CLASSNAME, LABEL)                                              \
  REGISTER_SYMBOL(CCI_Controller, CLASSNAME, LABEL, "undefined", "undefined", "undefined", \
                  "undefined", "undefined")
#else
// without dynamic loading, as on a real robot, the program contains one controller and creates it
// with this function
#define REGISTER_CONTROLLER(CLASSNAME, LABEL)                                     \
  extern "C" argos::CCI_Controller* ControllerMaker(const std::string& label) {   \
    if (label != LABEL) {                                                         \
      throw argos::CARGoSException("No controller \"" + label +                   \
                                   "\" in this program, expected \"" LABEL "\""); \
    }                                                                             \
    return new CLASSNAME;                                                         \
  }
#endif

#ifndef ARGOS_WITHOUT_COMPANIONS
#if __has_include(<lua.h>)
#include <argos3/core/wrappers/lua/lua_headers.h>
#endif
#endif

#endif
