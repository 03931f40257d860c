#include <argos3/testing/benchmark/flocks.h>

#include <argos3/testing/benchmark/pen.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/paths.h>

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/vector2.h>

#include <cmath>

namespace argos::testing {

namespace {

constexpr const char* kWheels = "<differential_steering implementation='default'/>";
constexpr UInt32 kBeacon = 12;  // index of the LED on top
constexpr const char* kProximity = "<footbot_proximity implementation='default'/>";

SExperiment MakeCrowd(UInt32 robots, UInt32 threads, const std::string& engine,
                      const std::string& attributes, const std::string& controller,
                      const std::string& robotAttributes = "") {
  constexpr Real kRobotsPerArea = 2.2;  // 1/m^2
  CPen pen(0.5 * std::sqrt(robots / kRobotsPerArea));
  pen.Distribute(0.1, robots,
                 "<foot-bot id='r' " + robotAttributes + "><controller config='c'/></foot-bot>");
  SExperiment experiment;
  experiment.Threads = threads;
  experiment.Controllers = controller;
  experiment.Engines = "<" + engine + " id='engine' " + attributes + "/>";
  experiment.ArenaSize = pen.GetArenaSize();
  experiment.Arena = pen.GetText();
  return experiment;
}

std::string TalkerText(const std::string& actuator, const std::string& sensor) {
  return "<talker id='c'><actuators>" + (kWheels + actuator) + "</actuators><sensors>" +
         (kProximity + sensor) + "</sensors></talker>";
}

// lengths of an attribute times a factor, but for the height
void ScaleGround(TConfigurationNode& node, const std::string& attribute, Real factor) {
  CVector3 lengths;
  GetNodeAttribute(node, attribute, lengths);
  SetNodeAttribute(node, attribute,
                   CVector3(factor * lengths.GetX(), factor * lengths.GetY(), lengths.GetZ()));
}

std::string MakeFlock(const std::string& file, UInt32 robots, UInt32 threads,
                      const std::string& engine, const std::string& attributes) {
  constexpr Real kRobots = 20.0;  // in the file
  CConfigurationDocument document;
  document.LoadFile(InSourceTree("experiments/" + file));
  TConfigurationNode& root = document.GetRoot();
  root.RemoveChild(&GetNode(root, "visualization"));
  TConfigurationNode& framework = GetNode(root, "framework");
  SetNodeAttribute(GetNode(framework, "system"), "threads", threads);
  SetNodeAttribute(GetNode(framework, "experiment"), "length", 0);
  TConfigurationNode& arena = GetNode(root, "arena");
  TConfigurationNode& distribute = GetNode(arena, "distribute");
  const Real factor = std::sqrt(robots / kRobots);
  ScaleGround(arena, "size", factor);
  ScaleGround(GetNode(distribute, "position"), "min", factor);
  ScaleGround(GetNode(distribute, "position"), "max", factor);
  SetNodeAttribute(GetNode(distribute, "entity"), "quantity", robots);
  if (TConfigurationNode& controllers = GetNode(root, "controllers");
      NodeExists(controllers, "lua_controller")) {
    SetNodeAttribute(GetNode(GetNode(controllers, "lua_controller"), "params"), "script",
                     InSourceTree("experiments/controllers/lua/flocking.lua"));
  }
  CConfigurationDocument engines;
  engines.Parse("<physics_engines><" + engine + " id='engine' " + attributes +
                "/></physics_engines>");
  root.RemoveChild(&GetNode(root, "physics_engines"));
  AddChildNode(root, engines.GetRoot());
  return document.ToText();
}

}  // namespace

void CTalker::Init(TConfigurationNode&) {
  m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  m_proximity = GetSensor<CCI_FootBotProximitySensor>("footbot_proximity");
  if (HasActuator("range_and_bearing")) {
    m_mouth = GetActuator<CCI_RangeAndBearingActuator>("range_and_bearing");
    m_ears = GetSensor<CCI_RangeAndBearingSensor>("range_and_bearing");
  } else {
    m_leds = GetActuator<CCI_LEDsActuator>("leds");
    m_eyes = GetSensor<CCI_ColoredBlobOmnidirectionalCameraSensor>(
        "colored_blob_omnidirectional_camera");
    m_eyes->Enable();
  }
}

void CTalker::ControlStep() {
  Drive();
  const auto said = static_cast<UInt8>(Listen() + 1);
  if (m_mouth != nullptr) {
    m_mouth->SetData(0, said);
  } else {
    m_leds->SetSingleColor(kBeacon, CColor(255, said, 0));
  }
}

void CTalker::Drive() {
  constexpr Real kSpeed = 10.0;  // cm/s
  CVector2 felt;
  for (const auto& reading : m_proximity->GetReadings()) {
    felt += CVector2(reading.Value, reading.Angle);
  }
  const bool isFree = felt.Length() < 0.1 || std::abs(felt.Angle().GetValue()) > 2.0;
  const Real left = felt.GetY() > 0.0 ? kSpeed : -kSpeed;
  m_wheels->SetLinearVelocity(isFree ? kSpeed : left, isFree ? kSpeed : -left);
}

UInt8 CTalker::Listen() const {
  UInt32 sum = 0;
  if (m_ears != nullptr) {
    for (const auto& message : m_ears->GetReadings()) {
      sum += message.Data[0];
    }
  } else {
    for (const auto* blob : m_eyes->GetReadings().BlobList) {
      sum += blob->Color.GetGreen();
    }
  }
  return static_cast<UInt8>(sum);
}

std::string MakeMessages(UInt32 robots, UInt32 threads, const std::string& engine,
                         const std::string& attributes) {
  SExperiment experiment =
      MakeCrowd(robots, threads, engine, attributes,
                TalkerText("<range_and_bearing implementation='default'/>",
                           "<range_and_bearing implementation='medium' medium='m'/>"),
                "rab_range='3' rab_data_size='4'");
  experiment.Media = "<range_and_bearing id='m'/>";
  return experiment.ToXml();
}

std::string MakeColors(UInt32 robots, UInt32 threads, const std::string& engine,
                       const std::string& attributes) {
  SExperiment experiment = MakeCrowd(
      robots, threads, engine, attributes,
      TalkerText("<leds implementation='default' medium='m'/>",
                 "<colored_blob_omnidirectional_camera implementation='rot_z_only' medium='m'/>"));
  experiment.Media = "<led id='m'/>";
  return experiment.ToXml();
}

std::string MakeScripts(UInt32 robots, UInt32 threads, const std::string& engine,
                        const std::string& attributes) {
  const std::string script = InSourceTree("experiments/controllers/lua/diffusion.lua");
  return MakeCrowd(robots, threads, engine, attributes,
                   "<lua_controller id='c'><actuators>" + std::string(kWheels) +
                       "</actuators><sensors>" + kProximity + "</sensors><params script='" +
                       script + "'/></lua_controller>")
      .ToXml();
}

std::string MakeFlocking(UInt32 robots, UInt32 threads, const std::string& engine,
                         const std::string& attributes) {
  return MakeFlock("flocking.argos", robots, threads, engine, attributes);
}

std::string MakeFlockingLua(UInt32 robots, UInt32 threads, const std::string& engine,
                            const std::string& attributes) {
  return MakeFlock("flocking_lua.argos", robots, threads, engine, attributes);
}

REGISTER_CONTROLLER(CTalker, "talker")

}  // namespace argos::testing
