#ifndef ARGOS3_TESTING_UNIT_PLUGINS_ENTITIES_COMPONENT_CHECKS_H
#define ARGOS3_TESTING_UNIT_PLUGINS_ENTITIES_COMPONENT_CHECKS_H

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/core/utility/math/vector3.h>

#include <catch2/catch.hpp>

namespace argos {

/** A body without a space. */
struct SBareBody {
  CComposableEntity Robot{nullptr, "robot"};
  CEmbodiedEntity Body{&Robot, "body_0"};
};

/** @return the digest of one entity's state. */
inline UInt64 DigestOf(const CEntity& entity) {
  CDigest digest;
  entity.UpdateDigest(digest);
  return digest.GetValue();
}

/** Checks that a component of ray sensors accepts neither an empty range nor an empty direction. */
template <typename SENSORS>
void CheckRefusesEmptyRays(SENSORS& sensors, SAnchor& anchor) {
  CHECK_THROWS_WITH(sensors.AddSensor(CVector3(), CVector3::X, 0.0, anchor),
                    Catch::Contains("range") && Catch::Contains("> 0"));
  CHECK_THROWS_WITH(sensors.AddSensor(CVector3(), CVector3(), 1.0, anchor),
                    Catch::Contains("direction"));
  CHECK(sensors.GetNumSensors() == 0);
}

}  // namespace argos

#endif
