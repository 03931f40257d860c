#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_CONTACTS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_CONTACTS_H

#include <argos3/core/utility/math/vector3.h>

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
  Real Force = 0.0;  // N, along the normal: before a substep that of the last one
  CVector3 Friction;  // N
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
  SRigidContact& Add() { return m_present.emplace_back(); }
  /** Gives the present contacts the forces of the last substep. */
  void InheritForces();
  /** The forces of the last substep are not inherited. */
  void Forget() { m_present.clear(); }

  const std::vector<SRigidContact>& Get() const { return m_present; }
  std::vector<SRigidContact>& Get() { return m_present; }

 private:
  void FillTable();
  size_t FindLast(UInt64 key) const;

  std::vector<SRigidContact> m_present;
  std::vector<SRigidContact> m_last;
  std::vector<UInt32> m_table;  // hash table: 1 + index of the first contact of a key in m_last
  std::vector<bool> m_isTaken;  // by index in m_last
};

}  // namespace argos

#endif
