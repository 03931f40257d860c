#ifndef ARGOS3_PLUGINS_ROBOTS_PROTOTYPE_SIMULATOR_JOINT_DEVICES_H
#define ARGOS3_PLUGINS_ROBOTS_PROTOTYPE_SIMULATOR_JOINT_DEVICES_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/plugins/simulator/entities/joint_equipped_entity.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <set>
#include <string>

namespace argos {

/** For the manuals of devices: a robot that has a joint. */
inline constexpr char kRobotWithJoint[] = R"(
on a robot with such a joint:

  <prototype id="p0">
    <body position="0,0,0" />
    <controller config="c1" />
    <links ref="base">
      <link id="base" geometry="box" size="0.1,0.1,0.05" mass="0.5" />
      <link id="arm" geometry="box" size="0.1,0.02,0.02" mass="0.1" />
    </links>
    <joints>
      <joint id="hinge" type="revolute" axis="0,1,0">
        <parent link="base" position="0,0,0.06" />
        <child link="arm" />
      </joint>
    </joints>
  </prototype>
)";

/**
 * Reads the children `<joint id="..." mode="..." />` of a device.
 * @tparam INTERFACE  has the enumeration EMode.
 * @param add  void(node, number of the joint, id, mode).
 * @throws CARGoSException if an id or a mode is unknown, or an id is repeated.
 */
template <typename INTERFACE, typename ADD>
void ForEachJointOfDevice(TConfigurationNode& tree, const CJointEquippedEntity& joints, ADD&& add) {
  using EMode = typename INTERFACE::EMode;
  std::set<std::string> known;
  TConfigurationNodeIterator child("joint");
  for (child = child.begin(&tree); child != child.end(); ++child) {
    std::string id;
    std::string mode;
    GetNodeAttribute(*child, "id", id);
    GetNodeAttribute(*child, "mode", mode);
    size_t joint = 0;
    try {
      joint = joints.FindJoint(id);
    } catch (CARGoSException& error) {
      THROW_ARGOSEXCEPTION_NESTED(OwnerOf(*child) << ": attribute \"id\"", error);
    }
    if (!known.insert(id).second) {
      THROW_ARGOSEXCEPTION(OwnerOf(*child) << ": joint \"" << id << "\" is listed twice");
    }
    if (mode != "position" && mode != "velocity" && mode != "disabled") {
      THROW_ARGOSEXCEPTION(OwnerOf(*child)
                           << ": unknown mode \"" << mode << "\""
                           << DidYouMean(mode, {"disabled", "position", "velocity"}));
    }
    add(*child, joint, id,
        mode == "position"   ? EMode::POSITION
        : mode == "velocity" ? EMode::VELOCITY
                             : EMode::DISABLED);
  }
}

}  // namespace argos

#endif
