#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_CONTACT_CACHE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_CONTACT_CACHE_H

#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/key_table.h>

#include <ode/ode.h>

#include <array>
#include <vector>

namespace argos {

struct SRigidBody;

/**
 * The contacts of pairs of solids, which stay the same points of both while these hardly move
 * against each other.
 *
 * If the four contacts of two faces were computed in each substep, rounding errors would move them
 * from corner to corner, and a stack would vibrate and never converge. While both solids
 * have moved against each other by less than kStill, depths follow from the motion of the points.
 */
class CContactCache {
 public:
  static constexpr int kMaxContacts = 4;

  /** Begins the next substep. */
  void StartSubstep();
  /** Keeps the present contacts of bodies that doze, besides those that are kept already. */
  void KeepDozing();
  /** To be called after the first substep of a tick, in which no body dozes. */
  void ForgetDozing() { m_dozing.Clear(); }
  /** Forgets all. */
  void Clear();
  /**
   * @param key  of the pair of solids. @param body  the movable one, or one of both. @param
   * contacts receives at most kMaxContacts.
   * @return their number; -1 if they are to be searched, and then given to Store().
   */
  int Find(UInt64 key, const SRigidBody& body, dGeomID first, dGeomID second, dContact* contacts);
  void Store(const dContact* contacts, int count);

 private:
  // a solid's frame
  struct SFrame {
    CVector3 Place;  // m
    std::array<CVector3, 3> Axes;

    CVector3 ToWorld(const CVector3& v) const;
    CVector3 ToOwn(const CVector3& v) const;
  };
  struct SPoint {
    CVector3 OfFirst;  // m, frame of the solid
    CVector3 OfSecond;
    CVector3 Normal;  // frame of the first, or of the second if that does not move
    Real Depth = 0.0;  // m
  };
  struct SPair {
    UInt64 Key = 0;
    const SRigidBody* Body = nullptr;
    CVector3 Place;  // of the second in the frame of the first, m
    std::array<CVector3, 3> Axes;
    int Count = 0;
    std::array<SPoint, kMaxContacts> Points;
  };

  static SFrame FrameOf(dGeomID solid);
  void Describe(dGeomID first, dGeomID second);
  bool IsStill(const SPair& last) const;
  const SPair* FindLast(UInt64 key);

  std::vector<SPair> m_present;
  CKeyTable<SPair> m_last;
  CKeyTable<SPair> m_dozing;
  size_t m_next = 0;  // in m_last: pairs come in nearly the same order in each substep
  // of the pair that is searched
  SFrame m_first;
  SFrame m_second;
  Real m_reach = 0.0;  // m; of the second's points from its centre
  bool m_isOfSecond = false;  // the normals
};

}  // namespace argos

#endif
