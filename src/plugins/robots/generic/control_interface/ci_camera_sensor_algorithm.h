#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_CAMERA_SENSOR_ALGORITHM_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_CAMERA_SENSOR_ALGORITHM_H

namespace argos {

class CLuaTable;

/** What is made of the pictures of a camera: see the derived classes for readings. */
class CCI_CameraSensorAlgorithm {
 public:
  virtual ~CCI_CameraSensorAlgorithm();

  /** The name of its element in the experiment file, and of its table in Lua. */
  virtual const char* GetLabel() const = 0;
  /** For Lua controllers: makes @p table a list of the readings; by default it stays as it is. */
  virtual void WriteReadings(CLuaTable& table) const;
};

}  // namespace argos

#endif
