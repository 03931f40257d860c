#include <argos3/testing/contract/physics_engines/drive_world.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace argos {

void CContractDriver::Init(TConfigurationNode& params) {
  m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  GetNodeAttributeOrDefault(params, "left", Left, Left);
  GetNodeAttributeOrDefault(params, "right", Right, Right);
}

std::string DriverXml(const std::string& tag, const std::string& id, Real x, Real y, Real yaw,
                      Real left, Real right) {
  std::ostringstream xml;
  xml << std::setprecision(17) << "<" << tag << " id='" << id << "'><body position='" << x << ","
      << y << ",0' orientation='" << yaw << ",0,0'/><controller config='driver'><params left='"
      << left << "' right='" << right << "'/></controller></" << tag << ">\n";
  return xml.str();
}

std::string WallXml(const std::string& id, const std::string& size, Real x, Real y, Real yaw) {
  std::ostringstream xml;
  xml << "<box id='" << id << "' size='" << size << "' movable='false'><body position='" << x << ","
      << y << ",0' orientation='" << yaw << ",0,0'/></box>";
  return xml.str();
}

std::string BoxXml(const std::string& id, Real x, Real y, Real yaw, const std::string& size) {
  std::ostringstream xml;
  xml << std::setprecision(17) << "<box id='" << id << "' size='" << size
      << "' movable='true' mass='1'><body position='" << x << "," << y << ",0' orientation='" << yaw
      << ",0,0'/></box>";
  return xml.str();
}

SExperiment CDriveWorld::Describe(const std::string& engine, const std::string& arena,
                                  UInt32 threads) {
  SExperiment experiment;
  experiment.Threads = threads;
  // an unused controller would be reported by a warning
  if (arena.find("config='driver'") != std::string::npos) {
    experiment.Controllers =
        "<contract_driver id='driver'><actuators><differential_steering implementation='default'/>"
        "</actuators><sensors/></contract_driver>";
  }
  experiment.Engines = engine;
  experiment.ArenaSize = "80,80,2";
  experiment.Arena = arena;
  return experiment;
}

CDriveWorld::CDriveWorld(const std::string& engine, const std::string& arena, UInt32 threads)
    : CDriveWorld(Describe(engine, arena, threads)) {}

CDriveWorld::CDriveWorld(const SExperiment& experiment)
    : CTestWorld(experiment), m_scope(GetSimulator()) {}

CEmbodiedEntity& CDriveWorld::Body(const std::string& id) {
  return Get<CComposableEntity>(id).GetComponent<CEmbodiedEntity>("body");
}

CVector3 CDriveWorld::Foot(const std::string& id) {
  const SAnchor& origin = Body(id).GetOriginAnchor();
  CVector3 up(0.0, 0.0, 0.015);
  return origin.Position + up.Rotate(origin.Orientation);
}

Real CDriveWorld::Yaw(const std::string& id) {
  CRadians z;
  CRadians y;
  CRadians x;
  Body(id).GetOriginAnchor().Orientation.ToEulerAngles(z, y, x);
  return z.GetValue();
}

CContractDriver& CDriveWorld::Driver(const std::string& id) {
  auto& controllable = Get<CComposableEntity>(id).GetComponent<CControllableEntity>("controller");
  return dynamic_cast<CContractDriver&>(controllable.GetController());
}

std::string CDriveWorld::EngineOf(const std::string& id) {
  if (Body(id).GetPhysicsModelsNum() != 1) {
    THROW_ARGOSEXCEPTION('"' << id << "\" is in " << Body(id).GetPhysicsModelsNum()
                             << " engines, not in one");
  }
  return Body(id).GetPhysicsModel(0).GetEngine().GetId();
}

Real CDriveWorld::Tilt(const std::string& id) {
  CVector3 up = CVector3::Z;
  up.Rotate(Body(id).GetOriginAnchor().Orientation);
  return std::acos(std::min(1.0, up.GetZ()));
}

SBodyMotion CDriveWorld::Motion(const std::string& id) {
  SBodyMotion motion;
  if (!Body(id).GetPhysicsModel(0).GetEngine().GetMotion(Body(id), motion)) {
    THROW_ARGOSEXCEPTION("the engine of \"" << id << "\" does not tell how it moves");
  }
  return motion;
}

void CDriveWorld::Launch(const std::string& id, const CVector3& velocity) {
  SBodyMotion motion;
  motion.Velocity = velocity;
  Body(id).GetPhysicsModel(0).GetEngine().SetMotion(Body(id), motion);
}

REGISTER_CONTROLLER(CContractDriver, "contract_driver")

void CDriveWorld::Reshape(const std::string& id, const SShapeDescription& shape) {
  CEmbodiedEntity& body = Body(id);
  auto description = std::make_shared<SBodyDescription>(*body.GetBodyDescription());
  description->Shapes = {shape};
  description->PlanarInertia.reset();
  GetSpace().RemoveEntityFromPhysicsEngines(body);
  body.SetBodyDescription(std::move(description));
  GetSpace().AddEntityToPhysicsEngine(body);
}

}  // namespace argos
