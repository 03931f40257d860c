#include "trails_loop_functions.h"

#include "../../controllers/epuck_trails/epuck_trails.h"

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/plugins/simulator/media/pheromone_medium.h>

#include <algorithm>
#include <cmath>

using namespace argos;

namespace {

// colour of the strongest trail; its grey of 0.74 differs clearly from those of nest and food
const CColor kTrailColor(255, 190, 0);

}  // namespace

void CTrailsLoopFunctions::SDisc::Read(TConfigurationNode& node) {
  GetNodeAttribute(node, "position", Center);
  GetNodeAttribute(node, "radius", Radius);
  if (!(Radius > 0.0)) {
    THROW_ARGOSEXCEPTION(node.GetLocation() << ": <" << node.Value() << ">: the radius is "
                                            << Radius << " m; it must be > 0");
  }
}

bool CTrailsLoopFunctions::SDisc::Contains(const CVector2& position) const {
  return SquareDistance(position, Center) < Radius * Radius;
}

void CTrailsLoopFunctions::Init(TConfigurationNode& node) {
  TConfigurationNode& trails = GetNode(node, "trails");
  std::string medium;
  GetNodeAttribute(trails, "medium", medium);
  m_medium = &GetSimulator().GetMedium<CPheromoneMedium>(medium);
  m_layer = m_medium->GetLayerNumber("trail");
  GetNodeAttributeOrDefault(trails, "full", m_full, m_full);
  GetNodeAttributeOrDefault(trails, "output", m_fileName, m_fileName);
  if (!(m_full > 0.0)) {
    THROW_ARGOSEXCEPTION("full is " << m_full << "; it must be > 0 (1/m^2)");
  }
  m_nest.Read(GetNode(trails, "nest"));
  TConfigurationNodeIterator food("food");
  for (food = food.begin(&trails); food != food.end(); ++food) {
    m_food.emplace_back().Read(*food);
  }
  Reset();
}

void CTrailsLoopFunctions::Reset() {
  m_data.Close();
  if (m_fileName.empty()) {
    return;
  }
  m_data.Open(m_fileName);
  m_data << "tick,carrying,delivered,trail\n";
}

void CTrailsLoopFunctions::Destroy() {
  m_data.Close();
}

CColor CTrailsLoopFunctions::GetFloorColor(const CVector2& position) {
  if (m_nest.Contains(position)) {
    return CColor::GRAY50;
  }
  for (const SDisc& food : m_food) {
    if (food.Contains(position)) {
      return CColor::BLACK;
    }
  }
  const Real concentration =
      m_medium->GetConcentration(m_layer, CVector3(position.GetX(), position.GetY(), 0.0));
  const Real strength = std::min<Real>(1.0, concentration / m_full);
  const auto blend = [strength](UInt8 color) {
    return static_cast<UInt8>(std::lround(255.0 - strength * (255.0 - color)));
  };
  return CColor(blend(kTrailColor.GetRed()), blend(kTrailColor.GetGreen()),
                blend(kTrailColor.GetBlue()));
}

void CTrailsLoopFunctions::PostStep() {
  GetSpace().GetFloorEntity().SetChanged();
  if (!m_data.IsOpen()) {
    return;
  }
  UInt32 carrying = 0;
  UInt64 delivered = 0;
  for (CControllableEntity* robot : GetSpace().GetControllableEntities()) {
    const auto& controller = dynamic_cast<const CEPuckTrails&>(robot->GetController());
    carrying += controller.HasFood() ? 1 : 0;
    delivered += controller.GetDelivered();
  }
  m_data << GetSpace().GetSimulationClock() << ',' << carrying << ',' << delivered << ','
         << m_medium->GetField(m_layer).ComputeTotal() << '\n';
}

REGISTER_LOOP_FUNCTIONS(CTrailsLoopFunctions, "trails_loop_functions")
