#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_CAMERA_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_CAMERA_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_algorithm.h>

#include <string>
#include <vector>

namespace argos {

/**
 * The cameras of a robot, each with algorithms that look at its pictures.
 *
 * Starts disabled: a controller calls Enable(), and has its first readings in the next step. A Lua
 * controller finds it enabled.
 */
class CCI_CameraSensor : virtual public CCI_Sensor {
 public:
  /** One camera. */
  struct SInterface {
    std::string Id;
    /** In the order of the file; not owned. Cast to CCI_CameraSensorLEDDetectorAlgorithm, ... */
    std::vector<CCI_CameraSensorAlgorithm*> Algorithms;

    typedef std::vector<SInterface> TVector;

    SInterface(const std::string& id, const std::vector<CCI_CameraSensorAlgorithm*>& algorithms);
  };

  /** One for each camera, in the order of the file. */
  const SInterface::TVector& GetInterfaces() const;

  /** robot.cameras.<id>.<algorithm>[i], see the algorithms; enables the sensor */
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;

 protected:
  SInterface::TVector m_vecInterfaces;
};

}  // namespace argos

#endif
