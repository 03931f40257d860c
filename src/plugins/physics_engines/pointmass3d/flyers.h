#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_POINTMASS3D_FLYERS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_POINTMASS3D_FLYERS_H

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/plugins/simulator/physics_engines/pointmass3d/point_mass_handle.h>

#include <array>
#include <vector>

namespace argos {

class CPointMass3DBody;
class CQuadRotorEntity;

/** The pose of a flying body. */
struct SFlightPose {
  CVector3 Position; /**< m */
  Real Yaw = 0.0; /**< rad, in [0, 2 pi) */
};

/** The state of one axis of a flying body: x, y, z (m, N) or yaw (rad, N m). */
struct SAxisState {
  Real Place = 0.0; /**< m or rad */
  Real Speed = 0.0; /**< per s */
  // of EFlightLaw::Argos3; else 0
  Real Thrust = 0.0; /**< N or N m, weight included; acts in the next substep */
  Real LastError = 0.0; /**< of the last substep */
};
/** x, y, z, yaw. */
using SFlightState = std::array<SAxisState, 4>;

/** How flying bodies are controlled. */
enum class EFlightLaw : UInt8 {
  Stable, /**< as the README of this folder says */
  Argos3 /**< as ARGoS 3.0.0-beta59: explicit, with the derivative of each error that of the last
            substep, and of the target, too */
};

/**
 * The flying bodies of an engine, and their motion.
 *
 * Bodies do not interact, so each is advanced by all substeps of a tick at once. They are stored in
 * blocks of kLanes, and a block is a structure of arrays: the arithmetic of a block is the same for
 * all its bodies and runs in vector registers. The kind of control of a body only selects numbers:
 * gains, targets, and whether the target is a position or a speed.
 *
 * Numbers of bodies are dense; removing one moves the last one into its place. A handle holds the
 * number of a body until then.
 */
class CFlyers : public CPointMassHandles {
 public:
  /** The constant properties of a body. */
  struct SSettings {
    CPointMass3DBody* Owner = nullptr;
    const CQuadRotorEntity* Quadrotor = nullptr; /**< has its commands; not owned */
    const SBodyDescription* Body = nullptr; /**< with propellers */
    CVector3 Lowest; /**< positions are kept in the box from here, m */
    CVector3 Highest; /**< to here, m */
    Real Gravity = 0.0; /**< m/s^2, along z */
  };

  size_t GetCount() const { return m_robots.size(); }
  /** Adds a body at rest. @return its handle, with the number GetCount() before the call. */
  SPointMassHandle Add(const SSettings& settings, const SFlightPose& pose);
  /** Removes a body. @return the body that now has its number, if any. */
  CPointMass3DBody* Remove(const SPointMassHandle& handle);
  void Clear();

  /** Sets the pose of a body, at rest, and resets its controllers. */
  void Place(UInt32 number, const SFlightPose& pose);
  SFlightPose GetPose(UInt32 number) const;
  SFlightState GetState(UInt32 number) const;
  void SetState(UInt32 number, const SFlightState& state);

  CPointMass3DBody& GetOwner(UInt32 number) const { return *m_robots[Checked(number)].Owner; }
  /** The longest substep that suits all bodies, s; infinite without bodies. */
  Real ComputeMaxSubstep() const;

  /**
   * Sets the origin of the frame in which the bodies are, m, world frame; to be called while there
   * are no bodies. Targets of positions are in the world frame.
   */
  void SetOrigin(const CVector3& origin) { m_origin = origin; }
  /** Selects the law of motion; to be called while there are no bodies. */
  void SetLaw(EFlightLaw law) { m_law = law; }
  /** Moves all bodies by @p substeps substeps. @param substep s. */
  void Advance(Real substep, UInt32 substeps);

 private:
  static constexpr size_t kLanes = 8;
  using TLanes = std::array<Real, kLanes>;

  // one axis of the bodies of a block; all arrays (lanes)
  struct SAxis {
    // state, see SAxisState
    TLanes Place{}, Speed{}, Thrust{}, LastError{};
    // the bodies: m or unused, per kg or kg m^2, N or N m
    TLanes Lowest{}, Highest{}, PerInertia{}, MaxThrust{};
    TLanes Weight{};  // N, along the axis; countered by the controller
    // of the tick, written by ReadCommand(): m or rad, or per s
    TLanes Target{};
    TLanes IsOnPlace{};  // 1: Target is a position; 0: a speed
    TLanes PerError{};  // thrust for an error
    // Stable: thrust against a speed; Argos3: thrust for a change of the error in a substep
    TLanes PerChange{};
  };
  struct SBlock {
    std::array<SAxis, 4> Axes;  // x, y, z, yaw
  };
  // the properties of a body besides its axes
  struct SRobot {
    CPointMass3DBody* Owner = nullptr;
    const CQuadRotorEntity* Quadrotor = nullptr;
    SControlGains Position, Yaw, Velocity, YawRate;
    Real Mass = 0.0;  // kg
    Real YawInertia = 0.0;  // kg m^2
    Real MaxSubstep = 0.0;  // s
  };

  UInt32 Checked(UInt32 number) const {
    ARGOS_ASSERT(number < GetCount(), "there is no flying body with the number " << number);
    return number;
  }
  SAxis& GetAxis(UInt32 number, size_t axis) {
    return m_blocks[Checked(number) / kLanes].Axes[axis];
  }
  const SAxis& GetAxis(UInt32 number, size_t axis) const {
    return m_blocks[Checked(number) / kLanes].Axes[axis];
  }
  template <EFlightLaw LAW>
  void ReadCommand(UInt32 number, Real substep);
  template <EFlightLaw LAW>
  void AdvanceAll(Real substep, UInt32 substeps);
  void Copy(UInt32 from, UInt32 to);
  template <EFlightLaw LAW, bool IS_ANGLE>
  static void AdvanceAxis(SAxis& axis, Real substep, UInt32 substeps);
  template <bool IS_ANGLE>
  static void AdvanceStably(SAxis& axis, Real substep);
  template <bool IS_ANGLE>
  static void AdvanceAsArgos3(SAxis& axis, Real substep);
  static void WrapPlaces(SAxis& axis);

  std::vector<SBlock> m_blocks;
  std::vector<SRobot> m_robots;
  EFlightLaw m_law = EFlightLaw::Stable;
  CVector3 m_origin;  // m, world frame
};

}  // namespace argos

#endif
