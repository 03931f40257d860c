#include <argos3/core/simulator/actuator.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/robots/generic/control_interface/ci_pheromone_actuator.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/robots/generic/simulator/medium_attribute.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>
#include <argos3/plugins/simulator/media/pheromone_medium.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace argos {

namespace {

/** Deposits substances of a medium under the robot. */
class CPheromoneMediumActuator : public CSimulatedActuator, public CCI_PheromoneActuator {
 public:
  /** @throws CARGoSException if the robot has no "body" or "controller". */
  void SetRobot(CComposableEntity& robot) override {
    m_robot = &robot.GetComponent<CControllableEntity>("controller");
    m_body = &robot.GetComponent<CEmbodiedEntity>("body");
  }
  /** Reads `medium`, `layers`, `offset` and `<noise>`. */
  void Init(TConfigurationNode& tree) override {
    CCI_PheromoneActuator::Init(tree);
    auto& medium =
        ReadMedium<CPheromoneMedium>(tree, m_robot->GetSimulator(), "a pheromone medium");
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
  /** @throws CARGoSException if a rate is not a number >= 0. */
  void Update() override {
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
  /** Sets all rates to 0 and restarts the noise. */
  void Reset() override {
    for (SInterface& interface : m_vecInterfaces) {
      interface.Rate = 0.0;
    }
    m_noise.Reset();
  }

 private:
  CControllableEntity* m_robot = nullptr;
  CEmbodiedEntity* m_body = nullptr;
  std::unique_ptr<CPheromoneMedium::CUser> m_user;
  std::vector<size_t> m_layers;  // numbers in the medium, (m_vecInterfaces)
  CVector3 m_offset;  // robot's frame, m
  CDeviceNoise m_noise;  // added to "rate"
};

}  // namespace

REGISTER_ACTUATOR(
    CPheromoneMediumActuator, "pheromone", "medium", "the authors of this project", "1.0",
    "Deposits substances on the ground.",
    R"(The controller sets the rate for each layer of a pheromone medium: the amount deposited per second. From the next
tick on, the robot deposits at this rate under its position before the motion of the tick, until the rate is changed;
rates are 0 at the start and after a reset. A deposit is distributed over the four cells whose centres surround the
point. Works on any robot with a body, at any height; deposits outside the medium's region are discarded.
)" + RequiredActuatorXML(R"(<pheromone implementation="medium" medium="pheromone" />)") +
        MediumXML(R"(<pheromone id="pheromone">
      <layer id="trail" />
    </pheromone>)",
                  "a pheromone medium") +
        OptionalXML(
            R"(<pheromone implementation="medium" medium="pheromone" layers="trail" offset="-0.05,0">
    <noise on="rate" model="gaussian" std_dev="0.1" relative="true" />
  </pheromone>)") +
        R"(
  layers  ids of layers, separated by commas; default: all layers of the medium.
  offset  "x,y", m, default "0,0": the point of deposit, in the robot's frame.
)" + NoiseManual("rate", "each rate that is not 0, in each tick; the sum is at least 0."),
    "Usable")

}  // namespace argos
