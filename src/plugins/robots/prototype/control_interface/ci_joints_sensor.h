#ifndef ARGOS3_PLUGINS_ROBOTS_PROTOTYPE_CONTROL_INTERFACE_CI_JOINTS_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_PROTOTYPE_CONTROL_INTERFACE_CI_JOINTS_SENSOR_H

#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

#include <string>
#include <vector>

namespace argos {

/** The positions or speeds of a robot's joints. */
class CCI_JointsSensor : public CVirtualTableSensor {
 public:
  /** The encoder of one joint. */
  struct SInterface {
    enum class EMode : UInt8 { DISABLED, POSITION, VELOCITY };

    std::string Id; /**< of the joint */
    EMode Mode; /**< of the experiment file */
    Real Value; /**< rad or m; rad/s or m/s; 0 at the start, and while disabled */

    typedef std::vector<SInterface> TVector;

    SInterface(const std::string& id, EMode mode);
  };

  /** One interface for each joint that is listed, in order. */
  const SInterface::TVector& GetInterfaces() const;

 protected:
  SInterface::TVector m_vecInterfaces;

 private:
  const char* GetLuaName() const override { return "joints"; }
  /** robot.joints.<id>.encoder */
  void WriteReadings(CLuaTable& table) const override;
  void ListNumbers(CNumberList& list) const override;
};

}  // namespace argos

#endif
