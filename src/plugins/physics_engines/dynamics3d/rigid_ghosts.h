#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_GHOSTS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_GHOSTS_H

#include <argos3/core/utility/configuration/argos_exception.h>
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
 * The cylinder that represents a robot at borders: around the origin, as in 2D engines. A robot
 * that lies on its side is represented by the sphere around it.
 */
SGhostCylinder EncloseRobot(const SBodyDescription& description, const SRigidPose& pose);

/** The greater of the horizontal and the vertical gap, m; below 0 if they overlap. */
Real ComputeGap(const SGhostCylinder& first, const SGhostCylinder& second);

/**
 * Robots of other engines near the border, in a tick of a rigid world.
 *
 * A robot of this world and one of another must not both use the gap between them. So for each
 * robot that may touch a ghost there is a face half-way between the two, as they were at the start
 * of the tick, with which only this robot collides. Objects without propellers or a drive, which
 * other worlds do not see, collide with the ghost itself.
 */
class CRigidGhosts {
 public:
  CRigidGhosts();
  ~CRigidGhosts();
  CRigidGhosts(const CRigidGhosts&) = delete;
  CRigidGhosts& operator=(const CRigidGhosts&) = delete;

  void Set(const std::vector<SGhostCylinder>& ghosts);
  bool IsEmpty() const { return m_ghosts.empty(); }
  const std::vector<SGhostCylinder>& Get() const { return m_ghosts; }
  /**
   * Finds the bodies that may touch a ghost in this tick, and wakes those that overlap one.
   * @param path        longest path of any body in the tick, m.
   * @param flyingPath  longest path of a robot with propellers, m.
   */
  void FindMeetings(const std::vector<SRigidBody*>& movables, Real path, Real flyingPath);

  /**
   * Calls visit(const SRigidBody& body, const SRigidBody& ghost) for each meeting; the solid of the
   * ghost is valid until the call returns.
   */
  template <typename VISIT>
  void ForEachMeeting(VISIT&& visit) const {
    for (const SFace& face : m_faces) {
      dGeomPlaneSetParams(m_face.Solids.front(), face.Normal.GetX(), face.Normal.GetY(),
                          face.Normal.GetZ(), face.Distance + m_face.Margin);
      visit(*face.Robot, m_face);
    }
    for (const SObstacle& obstacle : m_obstacles) {
      ARGOS_ASSERT(obstacle.Ghost < m_ghosts.size(), "there is no ghost " << obstacle.Ghost);
      MoveCylinder(m_ghosts[obstacle.Ghost]);
      visit(*obstacle.Object, m_cylinder);
    }
  }

 private:
  // a robot stays at points p with p * Normal >= Distance
  struct SFace {
    SRigidBody* Robot;
    CVector3 Normal;  // towards the robot
    Real Distance;  // m
  };
  struct SObstacle {
    SRigidBody* Object;
    UInt32 Ghost;  // in m_ghosts
  };

  void MoveCylinder(const SGhostCylinder& ghost) const;
  void FindRobotMeetings(SRigidBody& robot, Real path);
  void FindObjectMeetings(SRigidBody& object, Real path);
  bool IsInside(const SRigidBody& object, const SGhostCylinder& ghost) const;

  std::vector<SGhostCylinder> m_ghosts;
  CVector3 m_low;  // m: bounds of all
  CVector3 m_high;
  std::vector<SFace> m_faces;
  std::vector<SObstacle> m_obstacles;
  // without friction; their geoms are moved to one ghost after the other
  SRigidBody m_face;
  SRigidBody m_cylinder;
};

}  // namespace argos

#endif
