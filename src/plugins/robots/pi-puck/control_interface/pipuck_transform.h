#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_CONTROL_INTERFACE_PIPUCK_TRANSFORM_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_CONTROL_INTERFACE_PIPUCK_TRANSFORM_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>

#include <cstddef>
#include <string>
#include <utility>

namespace argos {

class CLuaTable;

/** Sets record.transform = { position, orientation, anchor }: the place of a sensor, m. */
void WriteTransform(CLuaTable& record, const CVector3& position, const CQuaternion& orientation,
                    const std::string& anchor);

/** Calls visit(const SInterface&) for each one of a sensor, whose Visit() of ARGoS 3 is not const.
 */
template <typename SENSOR, typename VISIT>
void VisitInterfaces(const SENSOR& sensor, VISIT&& visit) {
  const_cast<SENSOR&>(sensor).Visit(std::forward<VISIT>(visit));
}

/** For CopyReadings(): one value of each interface, by label. */
template <typename SENSOR>
void CopyInterfaces(const SENSOR& sensor, Real SENSOR::SInterface::*value, Real* numbers,
                    std::size_t count) {
  VisitInterfaces(sensor, [=](const typename SENSOR::SInterface& interface) {
    if (interface.Label < count) {
      numbers[interface.Label] = interface.*value;
    }
  });
}

}  // namespace argos

#endif
