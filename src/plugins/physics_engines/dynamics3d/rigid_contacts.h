#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_CONTACTS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_CONTACTS_H

#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/key_table.h>

#include <ode/ode.h>

#include <vector>

namespace argos {

struct SRigidBody;

/** A contact of a substep. */
struct SRigidContact {
  static constexpr UInt32 kNoWheel = 2;

  dContact Contact;  // the normal points to the first part
  dBodyID FirstPart = nullptr;  // null: does not move
  dBodyID SecondPart = nullptr;
  const SRigidBody* First = nullptr;
  const SRigidBody* Second = nullptr;
  UInt32 Counted = 0;  // active number of a movable one of both
  bool IsVoid = false;  // it does not act
  UInt32 Wheel = kNoWheel;  // of the first body, if that is what touches
  UInt64 Key = 0;  // the same in the next substep, and for all contacts of the same two solids
  CVector3 Place;  // in the frame of a movable body, m
  Real Patch = 0.0;  // m; radius of the surface that touches, where two objects have one contact
  Real Force = 0.0;  // N, along the normal: before a substep that of the last one
  CVector3 Friction;  // N
  Real Settled = 0.0;  // N: the force to which it has given way
};

/**
 * The contacts of a substep, which start with the forces of those of the last one.
 *
 * A settled tick allocates nothing.
 */
class CRigidContacts {
 public:
  /** Begins the next substep: the present contacts are those of the last one. */
  void StartSubstep();
  /**
   * Keeps the forces of the present contacts of bodies that doze (SRigidBody::Dozes) until they
   * are awake again, besides those that are kept already.
   */
  void KeepDozing();
  /** To be called after the first substep of a tick, in which no body dozes. */
  void ForgetDozing() { m_dozing.Clear(); }
  SRigidContact& Add() { return m_present.emplace_back(); }
  /** Gives the present contacts the forces of the last substep. */
  void InheritForces();
  /** The forces of the last substep are not inherited. */
  void Forget() {
    m_present.clear();
    m_dozing.Clear();
  }

  const std::vector<SRigidContact>& Get() const { return m_present; }
  std::vector<SRigidContact>& Get() { return m_present; }

 private:
  // what the next substep needs of a contact
  struct SMemory {
    UInt64 Key = 0;
    CVector3 Place;
    Real Force = 0.0;
    CVector3 Friction;
    Real Settled = 0.0;
  };

  static void Remember(const SRigidContact& contact, SMemory& memory);
  static bool Inherit(CKeyTable<SMemory>& memories, SRigidContact& contact,
                      std::vector<bool>& isTaken);

  std::vector<SRigidContact> m_present;
  CKeyTable<SMemory> m_last;
  CKeyTable<SMemory> m_dozing;
  std::vector<bool> m_isTaken;  // by index in m_last
  std::vector<bool> m_isDozingTaken;  // by index in m_dozing
};

}  // namespace argos

#endif
