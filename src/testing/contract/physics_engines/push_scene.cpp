#include <argos3/testing/contract/physics_engines/push_scene.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>

namespace argos {

using Catch::Matchers::WithinAbs;

namespace {

std::string Movable(Real mass) {
  // 0: it does not move
  return mass > 0.0 ? "movable='true' mass='" + std::to_string(mass) + "'" : "movable='false'";
}

}  // namespace

void CPushScene::AddRobot(const SPusher& robot, const std::string& id, Real x, Real y,
                          Real degrees) {
  const CVector3 place = Map(x, y);
  m_arena += DriverXml(robot.Tag, id, place.GetX(), place.GetY(), MapYaw(degrees),
                       100.0 * kPushSpeed, 100.0 * kPushSpeed);
}

void CPushScene::AddBox(const std::string& id, Real x, Real y, Real sizeX, Real sizeY, Real mass,
                        Real degrees) {
  AddSolid(x, y, degrees,
           "<box id='" + id + "' size='" + std::to_string(sizeX) + "," + std::to_string(sizeY) +
               ",0.1' " + Movable(mass),
           "box");
}

void CPushScene::AddCylinder(const std::string& id, Real x, Real y, Real radius, Real mass) {
  AddSolid(x, y, 0.0,
           "<cylinder id='" + id + "' radius='" + std::to_string(radius) + "' height='0.1' " +
               Movable(mass),
           "cylinder");
}

void CPushScene::AddPrism(const std::string& id, Real x, Real y, std::vector<CVector2> corners,
                          Real mass, Real degrees) {
  AddBox(id, x, y, 0.1, 0.1, mass, degrees);
  if (m_isMirrored) {
    for (CVector2& corner : corners) {
      corner.SetY(-corner.GetY());
    }
    std::reverse(corners.begin(), corners.end());
  }
  m_prisms.emplace_back(id, std::move(corners));
}

void CPushScene::Shape(CDriveWorld& world) const {
  for (const auto& [id, corners] : m_prisms) {
    world.Reshape(id, SShapeDescription::Prism(corners, 0.1));
  }
}

CVector3 CPushScene::PlaceOf(CDriveWorld& world, const std::string& id) const {
  CVector3 place = world.Position(id);
  place.RotateZ(CRadians(-m_degrees * std::numbers::pi / 180.0));
  return CVector3(place.GetX(), m_isMirrored ? -place.GetY() : place.GetY(), 0.0);
}

Real CPushScene::TurnOf(CDriveWorld& world, const std::string& id) const {
  return std::remainder(world.Yaw(id) - m_degrees * std::numbers::pi / 180.0,
                        2.0 * std::numbers::pi);
}

void CPushScene::AddSolid(Real x, Real y, Real degrees, const std::string& start,
                          const std::string& tag) {
  const CVector3 place = Map(x, y);
  std::ostringstream xml;
  xml << std::setprecision(17) << start << "><body position='" << place.GetX() << ","
      << place.GetY() << ",0' orientation='" << MapYaw(degrees) << ",0,0'/></" << tag << ">";
  m_arena += xml.str();
}

CVector3 CPushScene::Map(Real x, Real y) const {
  CVector3 place(x, m_isMirrored ? -y : y, 0.0);
  place.RotateZ(CRadians(m_degrees * std::numbers::pi / 180.0));
  return place;
}

void CPushScene::CheckWay(CDriveWorld& world, const std::string& id, UInt32 ticks, Real way,
                          Real tolerance) const {
  world.Step(ticks);
  const CVector3 place = PlaceOf(world, id);
  CHECK_THAT(place.GetX(), WithinAbs(way, tolerance));
  CHECK_THAT(place.GetY(), WithinAbs(0.0, 2e-3));
  CHECK_THAT(TurnOf(world, id), WithinAbs(0.0, 5e-3));
}

void CPushScene::CheckBalance(CDriveWorld& world, const std::string& id, UInt32 ticks,
                              bool yields) const {
  const CVector3 before = PlaceOf(world, id);
  world.Step(ticks);
  const CVector3 way = PlaceOf(world, id) - before;
  CHECK_THAT(way.GetX(), WithinAbs(yields ? -(ticks * kPushTick * kPushSpeed) : 0.0, 2e-3));
  CHECK_THAT(way.GetY(), WithinAbs(0.0, 1e-3));
  CHECK_THAT(TurnOf(world, id), WithinAbs(0.0, 5e-3));
}

std::string MakePushEngine(const SEngineType& engine, UInt32 iterations,
                           const SFriction& friction) {
  std::ostringstream xml;
  xml << std::setprecision(17) << "<friction box_linear_friction='" << friction.Force
      << "' box_angular_friction='" << friction.Torque << "' cylinder_linear_friction='"
      << friction.Force << "' cylinder_angular_friction='" << friction.Torque << "'/>";
  const std::string substeps =
      iterations > 0 ? " iterations='" + std::to_string(iterations) + "'" : "";
  return engine.ToXml("e", engine.GetPromptness() + substeps, xml.str());
}

std::string MakePushGround(const SEngineType& engine, UInt32 iterations, Real force) {
  if (engine.Ground == EGround::Force) {
    return MakePushEngine(engine, iterations, {force, force});
  }
  const std::string substeps =
      iterations > 0 ? "iterations='" + std::to_string(iterations) + "'" : "";
  return engine.ToXml("e", substeps, "<floor/><gravity g='9.81'/>");
}

}  // namespace argos
