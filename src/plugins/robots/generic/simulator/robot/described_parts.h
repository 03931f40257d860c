#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_DESCRIBED_PARTS_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_DESCRIBED_PARTS_H

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/visualization/appearance.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/plugins/simulator/entities/ray_layout.h>

#include <functional>

namespace argos {

/*
 * Parts that experiment files describe: of prototypes and of types of robots. All functions throw
 * CARGoSException with file and line if something is wrong.
 */

/**
 * A solid by its attribute `geometry`: `box` (`size`), `cylinder` (`radius`, `height`), `sphere`
 * (`radius`) or `convex_hull` (its text lists points). Its base is at the origin.
 */
SShapeDescription ReadSolid(TConfigurationNode& node);

/**
 * Calls add(child, ray) for the rays of each child `<sensor offset="..." direction="..."
 * range="..." />` and `<ring center="0,0,0" radius="..." start_angle="0" range="..."
 * num_sensors="..." />`.
 */
void ReadRays(TConfigurationNode& node,
              const std::function<void(TConfigurationNode&, const SSensorRay&)>& add);

/** A circle of devices: `center`, `radius`, `start_angle`, and their number. */
struct SDescribedRing {
  CVector3 Center; /**< m, default 0 */
  Real Radius = 0.0; /**< m, >= 0, required */
  CRadians Start; /**< default 0 */
  UInt32 Number = 0; /**< > 0, required */

  /** @param number  name of the attribute: "num_sensors". */
  SDescribedRing(TConfigurationNode& node, const char* number);
};

/** The attribute `material`, see EMaterial; plastic by default. */
EMaterial ReadMaterial(TConfigurationNode& node);

}  // namespace argos

#endif
