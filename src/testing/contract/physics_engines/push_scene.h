#ifndef ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_PUSH_SCENE_H
#define ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_PUSH_SCENE_H

#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/contract/physics_engines/engines.h>

#include <string>
#include <utility>
#include <vector>

namespace argos {

constexpr Real kPushSpeed = 0.1;  // m/s, of all robots
constexpr Real kPushTick = 0.1;  // s

/** A robot that pushes. */
struct SPusher {
  std::string Tag;
  Real Radius, Mass, Force;  // m, kg, N
};
inline const SPusher kFootBot{"foot-bot", 0.085036758, 1.6, 15.0};
inline const SPusher kEPuck{"e-puck", 0.035, 0.4, 1.5};

/** Friction of all objects on the ground. */
struct SFriction {
  Real Force, Torque;  // N, N m
};

/** A scene, and its copies: turned about the origin, and mirrored at the x axis before. */
class CPushScene {
 public:
  CPushScene(Real degrees, bool isMirrored) : m_degrees(degrees), m_isMirrored(isMirrored) {}

  void AddRobot(const SPusher& robot, const std::string& id, Real x, Real y, Real degrees);
  /** @param mass  kg; 0: it does not move. */
  void AddBox(const std::string& id, Real x, Real y, Real sizeX, Real sizeY, Real mass,
              Real degrees = 0.0);
  void AddCylinder(const std::string& id, Real x, Real y, Real radius, Real mass);
  /** A prism over a polygon, which Shape() makes of a box. */
  void AddPrism(const std::string& id, Real x, Real y, std::vector<CVector2> corners, Real mass,
                Real degrees = 0.0);
  void Shape(CDriveWorld& world) const;
  const std::string& GetArena() const { return m_arena; }

  /** The place of a body, as in the scene that is not turned, m. */
  CVector3 PlaceOf(CDriveWorld& world, const std::string& id) const;
  /** By how much a body has turned, rad. */
  Real TurnOf(CDriveWorld& world, const std::string& id) const;
  /**
   * Checks that in some ticks robots push a body from the origin along x by a way in m, and do not
   * turn it.
   */
  void CheckWay(CDriveWorld& world, const std::string& id, UInt32 ticks, Real way,
                Real tolerance) const;
  /**
   * Checks that for some ticks robots on both sides balance over a body, or, if it yields, that the
   * robots on the right push it at their speed.
   */
  void CheckBalance(CDriveWorld& world, const std::string& id, UInt32 ticks, bool yields) const;

 private:
  void AddSolid(Real x, Real y, Real degrees, const std::string& start, const std::string& tag);
  CVector3 Map(Real x, Real y) const;
  Real MapYaw(Real degrees) const { return m_degrees + (m_isMirrored ? -degrees : degrees); }

  Real m_degrees;
  bool m_isMirrored;
  std::string m_arena;
  std::vector<std::pair<std::string, std::vector<CVector2>>> m_prisms;
};

/** With friction of objects on the ground, in engines where it is a force. */
std::string MakePushEngine(const SEngineType& engine, UInt32 iterations, const SFriction& friction);
/** With friction of a force (N) on an object of a mass, which is its weight in dynamics3d. */
std::string MakePushGround(const SEngineType& engine, UInt32 iterations, Real force);

}  // namespace argos

#endif
