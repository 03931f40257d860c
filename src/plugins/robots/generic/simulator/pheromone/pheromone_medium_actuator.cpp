#include <argos3/core/simulator/actuator.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/robots/generic/control_interface/ci_pheromone_actuator.h>
#include <argos3/plugins/robots/generic/simulator/medium_attribute.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>
#include <argos3/plugins/simulator/media/pheromone_medium.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace argos {

namespace {

/** Lays substances of a medium under the robot. */
class CPheromoneMediumActuator : public CSimulatedActuator, public CCI_PheromoneActuator {
 public:
  /** @throws CARGoSException unless the robot has "body" and "controller". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `medium`, `layers`, `offset` and `<noise>`. @throws CARGoSException. */
  void Init(TConfigurationNode& tree) override;
  /** @throws CARGoSException that names the robot, if a rate is not a number >= 0. */
  void Update() override;
  /** Nothing is laid; noise starts over. */
  void Reset() override;

 private:
  CControllableEntity* m_robot = nullptr;
  CEmbodiedEntity* m_body = nullptr;  // of the robot
  std::unique_ptr<CPheromoneMedium::CUser> m_user;
  std::vector<size_t> m_layers;  // of the medium, (m_vecInterfaces)
  CVector3 m_offset;  // in the robot's frame, m
  CDeviceNoise m_noise;  // on "rate"
};

}  // namespace

void CPheromoneMediumActuator::SetRobot(CComposableEntity& robot) {
  m_robot = &robot.GetComponent<CControllableEntity>("controller");
  m_body = &robot.GetComponent<CEmbodiedEntity>("body");
}

void CPheromoneMediumActuator::Init(TConfigurationNode& tree) {
  CCI_PheromoneActuator::Init(tree);
  auto& medium = ReadMedium<CPheromoneMedium>(tree, m_robot->GetSimulator(), "a pheromone medium");
  m_layers = medium.ReadLayers(tree);
  for (const size_t layer : m_layers) {
    m_vecInterfaces.push_back({medium.GetLayerId(layer), 0.0});
  }
  CVector2 offset;
  GetNodeAttributeOrDefault(tree, "offset", offset, offset);
  m_offset.Set(offset.GetX(), offset.GetY(), 0.0);
  m_noise.Init(tree, *m_robot, {"rate"});
  m_user = std::make_unique<CPheromoneMedium::CUser>(medium, *m_robot);
}

void CPheromoneMediumActuator::Update() {
  for (size_t i = 0; i < m_layers.size(); ++i) {
    Real rate = CheckRate(m_vecInterfaces[i], m_vecInterfaces[i].Rate);
    if (rate > 0.0) {
      rate = std::max(0.0, m_noise.Apply(0, rate));
    }
    m_user->Rates[m_layers[i]] = rate;
    m_user->HasOrder = m_user->HasOrder || rate > 0.0;
  }
  if (m_user->HasOrder) {
    const SAnchor& origin = m_body->GetOriginAnchor();
    m_user->Place = m_offset;
    m_user->Place.Rotate(origin.Orientation);
    m_user->Place += origin.Position;
  }
}

void CPheromoneMediumActuator::Reset() {
  for (SInterface& interface : m_vecInterfaces) {
    interface.Rate = 0.0;
  }
  m_noise.Reset();
}

REGISTER_ACTUATOR(
    CPheromoneMediumActuator, "pheromone", "medium", "the authors of this project", "1.0",
    "Lays substances on the ground.",
    R"(The controller sets for each layer of a pheromone medium how much is laid per second. That much is laid in every
tick, from the next one on, under the robot as it is before it moves, until the rate is changed; rates are 0 at the start
and after a reset. It is shared among the four cells whose centres are around the place. Works on any robot with a body,
whatever its height; what is laid outside the medium's region is lost.

REQUIRED XML

  <controllers>
    <my_controller id="c1">
      <actuators>
        <pheromone implementation="medium" medium="pheromone" />
      </actuators>
      <sensors />
      <params />
    </my_controller>
  </controllers>

with the medium that it names:

  <media>
    <pheromone id="pheromone">
      <layer id="trail" />
    </pheromone>
  </media>

  medium  text, required: the id of a pheromone medium.

OPTIONAL XML

  <pheromone implementation="medium" medium="pheromone" layers="trail" offset="-0.05,0">
    <noise on="rate" model="gaussian" std_dev="0.1" relative="true" />
  </pheromone>

  layers  ids of layers, with commas between; default all of the medium.
  offset  "x,y", m, default "0,0": where substances are laid, in the robot's frame.
  noise   on="rate", for rates that are not 0, drawn in each tick; model="uniform" level, "gaussian" std_dev or
          "rayleigh" sigma; bias, relative="true". Rates stay >= 0.
)",
    "Usable")

}  // namespace argos
