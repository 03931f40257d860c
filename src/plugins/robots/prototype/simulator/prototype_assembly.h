#ifndef ARGOS3_PLUGINS_ROBOTS_PROTOTYPE_SIMULATOR_PROTOTYPE_ASSEMBLY_H
#define ARGOS3_PLUGINS_ROBOTS_PROTOTYPE_SIMULATOR_PROTOTYPE_ASSEMBLY_H

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/geometry/body_pose.h>
#include <argos3/core/utility/configuration/argos_configuration.h>

#include <memory>
#include <string>
#include <vector>

namespace argos {

/** A link of a prototype as it is placed at the start. */
struct SPlacedLink {
  std::string Id;
  SBodyPose Pose; /**< frame of the body, m */
  UInt32 Group = 0; /**< number of the link of the articulation: fixed joints join links */
};

/** A prototype put together. */
struct SPrototypeAssembly {
  std::vector<SPlacedLink> Links; /**< order of the file; SBodyDescription::Shapes likewise */
  std::shared_ptr<const SBodyDescription> Body;
};

/**
 * Reads `<links>` and `<joints>` of a prototype, and places the links.
 *
 * The reference link is at its `position`; joints place all others, since both frames of a joint
 * coincide at the start. A link elsewhere than its own `position` is warned of.
 * @param movable  false if the reference link is fixed to the world.
 * @throws CARGoSException with file and line for everything that is wrong.
 */
SPrototypeAssembly AssemblePrototype(TConfigurationNode& prototype, bool movable);

}  // namespace argos

#endif
