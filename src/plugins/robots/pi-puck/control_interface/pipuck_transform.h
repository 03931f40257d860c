#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_CONTROL_INTERFACE_PIPUCK_TRANSFORM_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_CONTROL_INTERFACE_PIPUCK_TRANSFORM_H

#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>

#include <string>

namespace argos {

class CLuaTable;

/** Sets record.transform = { position, orientation, anchor }: the place of a sensor, m. */
void WriteTransform(CLuaTable& record, const CVector3& position, const CQuaternion& orientation,
                    const std::string& anchor);

}  // namespace argos

#endif
