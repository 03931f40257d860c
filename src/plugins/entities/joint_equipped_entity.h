#ifndef ARGOS3_PLUGINS_ENTITIES_JOINT_EQUIPPED_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_JOINT_EQUIPPED_ENTITY_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/simulator/geometry/articulation.h>

#include <memory>
#include <string>
#include <vector>

namespace argos {

/**
 * The joints of an articulated body: commands of their motors, and their coordinates.
 *
 * Engines read the commands and write the coordinates. Joint i is that of
 * SArticulation::Joints.
 */
class CJointEquippedEntity : public CEntity {
 public:
  ENABLE_VTABLE();

  enum class EMode : UInt8 {
    Disabled, /**< the joint moves freely within its limits */
    Position, /**< the motor moves the joint towards the target coordinate */
    Velocity /**< the motor moves the joint at the target speed */
  };

  /** What the motor of a joint does. */
  struct SCommand {
    EMode Mode = EMode::Disabled;
    Real Target = 0.0; /**< rad or m; rad/s or m/s */
    Real MaxImpulse = 0.0; /**< N m s or N s, >= 0: bound of the motor in a substep */

    bool operator==(const SCommand& other) const {
      return Mode == other.Mode && Target == other.Target && MaxImpulse == other.MaxImpulse;
    }
    bool operator!=(const SCommand& other) const { return !(*this == other); }
  };

  struct SJoint {
    SCommand Command;
    Real Position = 0.0; /**< rad, not wrapped, or m; 0 at the start */
    Real Velocity = 0.0; /**< rad/s or m/s */
  };

  CJointEquippedEntity(CComposableEntity* parent, const std::string& id,
                       std::shared_ptr<const SArticulation> articulation);

  /** Disables all motors, and sets all coordinates to 0. */
  void Reset() override;
  std::string GetTypeDescription() const override { return "joints"; }

  size_t GetNumJoints() const { return m_joints.size(); }
  /** Throws if the index is out of range, like the next four functions. */
  const SJoint& GetJoint(size_t index) const;
  const SJointDescription& GetDescription(size_t index) const;
  /**
   * @return the number of the joint of that id.
   * @throws CARGoSException with the known ids if there is none, or if it is a ball joint, which
   * has neither a coordinate nor a motor.
   */
  size_t FindJoint(const std::string& id) const;
  /** @throws CARGoSException if a number is not finite or the impulse is negative. */
  void SetCommand(size_t index, const SCommand& command);
  /** For engines. */
  void SetState(size_t index, Real position, Real velocity);
  /** For engines: true if a command has changed since the last call. */
  bool TakeChange();

  void UpdateDigest(CDigest& digest) const override;

 private:
  void CheckIndex(size_t index) const;

  std::shared_ptr<const SArticulation> m_articulation;
  std::vector<SJoint> m_joints;
  bool m_hasChanged = true;
};

}  // namespace argos

#endif
