#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_GHOSTS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_GHOSTS_H

#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>

#include <vector>

namespace argos {

/** The upright cylinder around a robot, world frame. */
struct SGhostCylinder {
  Real X = 0.0;  // m
  Real Y = 0.0;  // m
  Real Radius = 0.0;  // m
  Real Low = 0.0;  // m
  Real High = 0.0;  // m
};

/**
 * The cylinder that stands for a robot at borders: around the origin, as engines in which robots
 * stand on a plane have it. One that lies counts as the sphere around it.
 */
SGhostCylinder EncloseRobot(const SBodyDescription& description, const SRigidPose& pose);

/** How far two of them are apart, across or up, whichever is farther, m; below 0 they overlap. */
Real ComputeGap(const SGhostCylinder& first, const SGhostCylinder& second);

/**
 * Robots of other engines near the border, in a tick of a rigid world.
 *
 * A robot of this world and one of another must not both take the gap between them. So for each
 * robot that may meet a ghost there is a face half-way between the two, as they were at the start
 * of the tick, which only it can feel. Things without propellers or a drive, of which other worlds
 * know nothing, feel the ghost itself.
 */
class CRigidGhosts {
 public:
  CRigidGhosts();
  ~CRigidGhosts();
  CRigidGhosts(const CRigidGhosts&) = delete;
  CRigidGhosts& operator=(const CRigidGhosts&) = delete;

  void Set(const std::vector<SGhostCylinder>& ghosts);
  bool IsEmpty() const { return m_ghosts.empty(); }
  /**
   * Finds who may meet a ghost in this tick, and wakes who is inside of one.
   * @param path        m, the longest way that anything goes in the tick, and
   * @param flyingPath  that a robot with propellers goes.
   */
  void Meet(const std::vector<SRigidBody*>& movables, Real path, Real flyingPath);

  /**
   * Calls visit(const SRigidBody& body, const SRigidBody& ghost) for each meeting; the ghost's
   * solid is what the body feels, and stays that until the call returns.
   */
  template <typename VISIT>
  void ForEachMeeting(VISIT&& visit) const {
    for (const SFace& face : m_faces) {
      dGeomPlaneSetParams(m_face.Solids.front(), face.Normal.GetX(), face.Normal.GetY(),
                          face.Normal.GetZ(), face.Distance + m_face.Margin);
      visit(*face.Robot, m_face);
    }
    for (const SObstacle& obstacle : m_obstacles) {
      PutCylinder(m_ghosts[obstacle.Ghost]);
      visit(*obstacle.Thing, m_cylinder);
    }
  }

 private:
  // what a robot is to be beyond: the points p with p * Normal = Distance
  struct SFace {
    SRigidBody* Robot;
    CVector3 Normal;  // towards the robot
    Real Distance;  // m
  };
  struct SObstacle {
    SRigidBody* Thing;
    UInt32 Ghost;  // in m_ghosts
  };

  void PutCylinder(const SGhostCylinder& ghost) const;
  void MeetRobot(SRigidBody& robot, Real path);
  void MeetThing(SRigidBody& thing, Real path);
  bool IsInside(const SRigidBody& thing, const SGhostCylinder& ghost) const;

  std::vector<SGhostCylinder> m_ghosts;
  CVector3 m_low;  // m: bounds of all
  CVector3 m_high;
  std::vector<SFace> m_faces;
  std::vector<SObstacle> m_obstacles;
  // without friction; their geoms take the place of one ghost after the other
  SRigidBody m_face;
  SRigidBody m_cylinder;
};

}  // namespace argos

#endif
