#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_CAMERA_SENSOR_ALGORITHM_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_CAMERA_SENSOR_ALGORITHM_H

namespace argos {

class CLuaTable;

/** An algorithm that processes the images of a camera; see the derived classes for readings. */
class CCI_CameraSensorAlgorithm {
 public:
  virtual ~CCI_CameraSensorAlgorithm();

  /** Name of the XML element, and of the table in Lua. */
  virtual const char* GetLabel() const = 0;
  /** For Lua controllers: writes the list of readings to @p table; by default does nothing. */
  virtual void WriteReadings(CLuaTable& table) const;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/utility/configuration/base_configurable_resource.h>
#endif

#endif
