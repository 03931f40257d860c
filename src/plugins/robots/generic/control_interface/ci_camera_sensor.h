#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_CAMERA_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_CAMERA_SENSOR_H

#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_algorithm.h>
#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

#include <string>
#include <vector>

namespace argos {

/**
 * The cameras of a robot, with algorithms that process their images.
 *
 * Starts disabled: a controller calls Enable(), and has its first readings in the next step. For
 * Lua controllers it is enabled from the start.
 */
class CCI_CameraSensor : public CVirtualTableSensor {
 public:
  /** One camera. */
  struct SInterface {
    std::string Id;
    /** In the order of the file; not owned. Cast to CCI_CameraSensorLEDDetectorAlgorithm, ... */
    std::vector<CCI_CameraSensorAlgorithm*> Algorithms;

    typedef std::vector<SInterface> TVector;

    SInterface(const std::string& id, const std::vector<CCI_CameraSensorAlgorithm*>& algorithms);
  };

  /** One interface for each camera, in the order of the file. */
  const SInterface::TVector& GetInterfaces() const;

 protected:
  SInterface::TVector m_vecInterfaces;

 private:
  const char* GetLuaName() const override { return "cameras"; }
  /** Enables the sensor: Lua has no function for it. */
  void WriteConstants(CLuaTable& table) override;
  /** robot.cameras.<id>.<algorithm>[i], see the algorithms */
  void WriteReadings(CLuaTable& table) const override;
};

}  // namespace argos

#endif
