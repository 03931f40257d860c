#include <argos3/testing/determinism/swarm.h>

#include <cmath>
#include <sstream>

namespace argos {

namespace {

constexpr Real kSpeed = 12.0;  // cm/s
constexpr Real kNear = 0.15;  // sum of readings that counts as an obstacle

std::string Controllers(bool withLEDs) {
  const std::string leds = withLEDs ? "<leds implementation='default' medium='leds' />" : "";
  return R"(
  <walker id='foot-bot'>
    <actuators>
      <differential_steering implementation='default' bias_stddev='0.002' factor_stddev='0.05' />)" +
         leds + R"(
    </actuators>
    <sensors> <footbot_proximity implementation='default' noise_level='0.05' /> </sensors>
  </walker>
  <walker id='e-puck'>
    <actuators>
      <differential_steering implementation='default' factor_stddev='0.1' />)" +
         leds + R"(
    </actuators>
    <sensors> <epuck_proximity implementation='default' noise_level='0.05' /> </sensors>
  </walker>)";
}

class CArena {
 public:
  explicit CArena(Real side) : m_side(side) {}

  void AddWalls() {
    const Real middle = 0.5 * m_side + 0.05;
    const Real length = m_side + 0.2;
    AddWall("north", 0.0, middle, length, 0.1);
    AddWall("south", 0.0, -middle, length, 0.1);
    AddWall("east", middle, 0.0, 0.1, length);
    AddWall("west", -middle, 0.0, 0.1, length);
  }

  void Distribute(const std::string& orientation, UInt32 quantity, const std::string& entity) {
    const Real reach = 0.5 * m_side - 0.1;
    m_xml << "<distribute> <position method='uniform' min='" << -reach << "," << -reach
          << ",0' max='" << reach << "," << reach << ",0' />\n<orientation method='uniform' min='"
          << orientation << ",0,0' max='180,0,0' />\n<entity quantity='" << quantity
          << "' max_trials='1000'> " << entity << " </entity> </distribute>\n";
  }

  std::string ToXml() const { return m_xml.str(); }

 private:
  void AddWall(const std::string& id, Real x, Real y, Real sizeX, Real sizeY) {
    m_xml << "<box id='" << id << "' size='" << sizeX << "," << sizeY
          << ",0.3' movable='false'> <body position='" << x << "," << y << ",0' /> </box>\n";
  }

  Real m_side;
  std::ostringstream m_xml;
};

std::string Engines(const std::string& type, Real side, UInt32 perSide) {
  if (perSide == 1) {
    return "<" + type + " id='engine' />";
  }
  // the outer engines extend beyond the walls
  const Real outer = 0.5 * side + 1.0;
  const auto edge = [&](UInt32 i) {
    return i == 0 ? -outer : (i == perSide ? outer : -0.5 * side + i * side / perSide);
  };
  std::ostringstream xml;
  for (UInt32 i = 0; i < perSide; ++i) {
    for (UInt32 j = 0; j < perSide; ++j) {
      xml << "<" << type << " id='engine_" << i << j << "'> <boundaries> <sides>";
      const Real corners[4][2] = {{edge(i), edge(j)},
                                  {edge(i + 1), edge(j)},
                                  {edge(i + 1), edge(j + 1)},
                                  {edge(i), edge(j + 1)}};
      for (const auto& corner : corners) {
        xml << "<vertex point='" << corner[0] << "," << corner[1] << "' />";
      }
      xml << "</sides> </boundaries> </" << type << ">\n";
    }
  }
  return xml.str();
}

}  // namespace

void CWalker::Init(TConfigurationNode&) {
  m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  if (HasActuator("leds")) {
    m_leds = GetActuator<CCI_LEDsActuator>("leds");
  }
  if (HasSensor("footbot_proximity")) {
    m_footBotEyes = GetSensor<CCI_FootBotProximitySensor>("footbot_proximity");
  } else {
    m_ePuckEyes = GetSensor<CCI_EPuckProximitySensor>("epuck_proximity");
  }
  m_random = CRandom::CreateRNG("argos");
}

void CWalker::Reset() {
  m_turnTicks = 0;
  m_turn = 0.0;
}

void CWalker::ControlStep() {
  const Real left = SumUp(true);
  const Real right = SumUp(false);
  if (left > kNear || right > kNear) {
    m_turn = left > right ? 1.0 : -1.0;
    m_turnTicks = 1 + m_random->Uniform(CRange<UInt32>(0, 5));
  } else if (m_turnTicks == 0 && m_random->Bernoulli(0.05)) {
    m_turn = m_random->Uniform(CRange<Real>(-1.0, 1.0));
    m_turnTicks = 10;
  }
  if (m_turnTicks > 0) {
    --m_turnTicks;
    m_wheels->SetLinearVelocity(m_turn * kSpeed, -m_turn * kSpeed);
  } else {
    m_wheels->SetLinearVelocity(kSpeed, kSpeed);
  }
  if (m_leds == nullptr) {
    return;
  }
  if (m_turnTicks > 0) {
    m_leds->SetSingleColor(m_turnTicks % static_cast<UInt32>(m_leds->GetNumLEDs()), CColor::RED);
  } else {
    m_leds->SetAllColors(CColor::GREEN);
  }
}

Real CWalker::SumUp(bool left) const {
  Real sum = 0.0;
  const auto add = [&](const CRadians& angle, Real value) {
    if (Abs(angle) < CRadians::PI_OVER_TWO && (angle > CRadians::ZERO) == left) {
      sum += value;
    }
  };
  if (m_footBotEyes != nullptr) {
    for (const auto& reading : m_footBotEyes->GetReadings()) {
      add(reading.Angle, reading.Value);
    }
  } else {
    for (const auto& reading : m_ePuckEyes->GetReadings()) {
      add(reading.Angle, reading.Value);
    }
  }
  return sum;
}

REGISTER_CONTROLLER(CWalker, "walker")

SExperiment Swarm(UInt32 robots, UInt32 enginesPerSide, bool withLEDs, const std::string& engine) {
  const Real side = 0.4 * std::sqrt(static_cast<Real>(robots)) + 0.5;
  CArena arena(side);
  arena.AddWalls();
  const UInt32 some = std::max(1U, robots / 10);
  arena.Distribute("-180", some, "<box id='box' size='0.15,0.1,0.2' movable='false' />");
  arena.Distribute("-180", some, "<box id='crate' size='0.1,0.1,0.1' movable='true' mass='0.3' />");
  arena.Distribute("180", some,
                   "<cylinder id='post' radius='0.05' height='0.3' movable='false' />");
  arena.Distribute("180", some,
                   "<cylinder id='drum' radius='0.04' height='0.1' movable='true' mass='0.2' />");
  arena.Distribute("-180", robots - robots / 2,
                   "<foot-bot id='fb'> <controller config='foot-bot' /> </foot-bot>");
  arena.Distribute("-180", robots / 2, "<e-puck id='ep'> <controller config='e-puck' /> </e-puck>");
  SExperiment experiment;
  experiment.Controllers = Controllers(withLEDs);
  experiment.Engines = Engines(engine, side, enginesPerSide);
  experiment.Media = "<led id='leds' />";
  const Real size = side + 2.0;
  std::ostringstream arenaSize;
  arenaSize << size << "," << size << ",1";
  experiment.ArenaSize = arenaSize.str();
  experiment.Arena = arena.ToXml();
  return experiment;
}

}  // namespace argos
