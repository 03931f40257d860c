#include "foraging_loop_functions.h"

#include "../../controllers/footbot_foraging/footbot_foraging.h"

#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>

using namespace argos;

void CForagingLoopFunctions::Init(TConfigurationNode& node) {
  TConfigurationNode& foraging = GetNode(node, "foraging");
  UInt32 numItems = 10;
  GetNodeAttributeOrDefault(foraging, "items", numItems, numItems);
  GetNodeAttributeOrDefault(foraging, "radius", m_radius, m_radius);
  GetNodeAttributeOrDefault(foraging, "area_x", m_areaX, m_areaX);
  GetNodeAttributeOrDefault(foraging, "area_y", m_areaY, m_areaY);
  GetNodeAttributeOrDefault(foraging, "output", m_fileName, m_fileName);
  if (!(m_radius > 0.0)) {
    THROW_ARGOSEXCEPTION("the radius of food is " << m_radius << " m; it must be > 0");
  }
  m_rng = CRandom::CreateRNG("argos");
  m_items.resize(numItems);
  Reset();
}

void CForagingLoopFunctions::Reset() {
  m_delivered = 0;
  for (CVector2& item : m_items) {
    Grow(item);
  }
  GetSpace().GetFloorEntity().SetChanged();
  OpenData();
}

void CForagingLoopFunctions::Destroy() {
  m_data.Close();
}

void CForagingLoopFunctions::OpenData() {
  if (m_fileName.empty()) {
    return;
  }
  m_data.Open(m_fileName);
  m_data << "tick,out,resting,delivered\n";
}

void CForagingLoopFunctions::Grow(CVector2& item) {
  item.Set(m_rng->Uniform(m_areaX), m_rng->Uniform(m_areaY));
}

CColor CForagingLoopFunctions::GetFloorColor(const CVector2& position) {
  if (position.GetX() < 0.0) {
    return CColor::GRAY50;
  }
  for (const CVector2& item : m_items) {
    if (SquareDistance(position, item) < m_radius * m_radius) {
      return CColor::BLACK;
    }
  }
  return CColor::WHITE;
}

bool CForagingLoopFunctions::TakeOrDeliver(CFootBotForaging& controller, const CVector2& position) {
  CFootBotForaging::SFood& food = controller.GetFood();
  if (food.Has) {
    if (position.GetX() >= -0.2) {
      return false;
    }
    food.Has = false;
    ++food.Delivered;
    ++m_delivered;
    return true;
  }
  if (controller.GetState() != CFootBotForaging::EState::Exploring) {
    return false;
  }
  for (CVector2& item : m_items) {
    if (SquareDistance(position, item) < m_radius * m_radius) {
      food.Has = true;
      Grow(item);
      return true;
    }
  }
  return false;
}

void CForagingLoopFunctions::PreStep() {
  UInt32 resting = 0;
  UInt32 out = 0;
  bool changed = false;
  for (auto& [id, entity] : GetSpace().GetEntitiesByType("foot-bot")) {
    auto& robot = *any_cast<CFootBotEntity*>(entity);
    auto& controller =
        dynamic_cast<CFootBotForaging&>(robot.GetControllableEntity().GetController());
    const CVector3& position = robot.GetEmbodiedEntity().GetOriginAnchor().Position;
    changed = TakeOrDeliver(controller, CVector2(position.GetX(), position.GetY())) || changed;
    ++(controller.GetState() == CFootBotForaging::EState::Resting ? resting : out);
  }
  SetMetric("delivered", static_cast<Real>(m_delivered));
  SetMetric("out", out);
  SetMetric("resting", resting);
  if (changed) {
    GetSpace().GetFloorEntity().SetChanged();
  }
  if (m_data.IsOpen()) {
    m_data << GetSpace().GetSimulationClock() << ',' << out << ',' << resting << ',' << m_delivered
           << '\n';
  }
}

REGISTER_LOOP_FUNCTIONS(CForagingLoopFunctions, "foraging_loop_functions")
