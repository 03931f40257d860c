#ifndef ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_DRIVE_SOURCE_H
#define ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_DRIVE_SOURCE_H

#include <argos3/core/simulator/physics_engine/planar_motion.h>

#include <string>

namespace argos {

class CEmbodiedEntity;

/**
 * Where a robot's drive reads its command in every tick: the speeds of two wheels, or a command.
 *
 * Both belong to a component of the robot, and must stay valid.
 */
class CDriveSource {
 public:
  /** No drive. */
  CDriveSource() = default;
  /**
   * @param wheels              speeds of the left and the right wheel, m/s.
   * @param interwheelDistance  m, > 0.
   */
  CDriveSource(const Real* wheels, Real interwheelDistance)
      : m_source(wheels), m_inverseInterwheel(1.0 / interwheelDistance) {}
  explicit CDriveSource(const SDriveCommand& command) : m_source(&command) {}

  /** @return true if there is a drive. */
  explicit operator bool() const { return m_source != nullptr; }
  bool HasWheels() const { return m_inverseInterwheel != 0.0; }
  /** Speeds of the left and the right wheel, m/s; HasWheels() must be true. */
  const Real* GetWheels() const { return static_cast<const Real*>(m_source); }
  /** There must be a drive. */
  SDriveCommand Read() const {
    if (!HasWheels()) {
      return *static_cast<const SDriveCommand*>(m_source);
    }
    const Real left = GetWheels()[0];
    const Real right = GetWheels()[1];
    return {0.5 * (left + right), 0.0, (right - left) * m_inverseInterwheel};
  }
  /** The present command for messages: "left = 1 m/s, right = 2 m/s". */
  std::string Describe() const;

 private:
  const void* m_source = nullptr;  // speeds of wheels, m/s, (left, right), or an SDriveCommand
  Real m_inverseInterwheel = 0.0;  // 1/m; 0: there are no wheels
};

/** Thrown by an engine's world if a command is not finite; nothing has moved then. */
struct SBadDriveCommand {
  const CEmbodiedEntity* Robot;
  CDriveSource Drive;
};

/** @throws CARGoSException that names the robot and its command. */
[[noreturn]] void ThrowBadCommand(const SBadDriveCommand& bad);

}  // namespace argos

#endif
