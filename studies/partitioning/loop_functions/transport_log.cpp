#include "transport_log.h"

#include "../controllers/transporter.h"

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/simulator/entities/cylinder_entity.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>

using namespace argos;

namespace {

constexpr UInt32 kWindow = 15 * 60 * 10;  // ticks
constexpr UInt32 kTrials = 100;
constexpr Real kMeters = 0.01;  // in a centimetre

CVector2 PlaceOf(const CFootBotEntity& robot) {
  const CVector3& position = robot.GetEmbodiedEntity().GetOriginAnchor().Position;
  return CVector2(position.GetX(), position.GetY());
}

CRadians HeadingOf(const CFootBotEntity& robot) {
  CRadians z;
  CRadians y;
  CRadians x;
  robot.GetEmbodiedEntity().GetOriginAnchor().Orientation.ToEulerAngles(z, y, x);
  return z;
}

}  // namespace

void CTransportLog::Init(TConfigurationNode& node) {
  GetNodeAttributeOrDefault(node, "nest", m_nest, m_nest);
  GetNodeAttributeOrDefault(node, "source", m_source, m_source);
  GetNodeAttributeOrDefault(node, "radius", m_radius, m_radius);
  GetNodeAttributeOrDefault(node, "output", m_fileName, m_fileName);
  m_rng = CRandom::CreateRNG("argos");
  for (auto& [id, entity] : GetSpace().GetEntitiesByType("foot-bot")) {
    auto& robot = *any_cast<CFootBotEntity*>(entity);
    auto& controller = dynamic_cast<CTransporter&>(robot.GetControllableEntity().GetController());
    m_robots.push_back({&robot, &controller, 0, 0, CVector2(), CRadians::ZERO});
  }
  for (auto& [id, entity] : GetSpace().GetEntitiesByType("cylinder")) {
    m_objects.push_back(any_cast<CCylinderEntity*>(entity));
  }
  Start();
}

void CTransportLog::Reset() {
  Start();
}

void CTransportLog::Destroy() {
  m_file.Close();
}

void CTransportLog::Start() {
  m_deliveries.clear();
  m_delivered = 0;
  m_sumOfErrors = 0.0;
  m_numErrors = 0;
  for (SRobot& robot : m_robots) {
    robot.NumGrips = 0;
    robot.NumArrivals = 0;
  }
  m_file.Open(m_fileName);
  m_file << "tick,robot,x,y\n";
}

CColor CTransportLog::GetFloorColor(const CVector2& position) {
  return position.GetY() < m_nest ? CColor::GRAY50 : CColor::WHITE;
}

void CTransportLog::PostStep() {
  PutBackDelivered();
  UInt32 lost = 0;
  for (SRobot& robot : m_robots) {
    Follow(robot);
    lost += robot.Controller->GetNumLost();
  }
  const UInt32 now = GetSpace().GetSimulationClock();
  while (!m_deliveries.empty() && m_deliveries.front() + kWindow <= now) {
    m_deliveries.pop_front();
  }
  SetMetric("delivered", m_delivered);
  SetMetric("throughput", static_cast<Real>(m_deliveries.size()));
  SetMetric("lost", lost);
  if (m_numErrors > 0) {
    SetMetric("error", m_sumOfErrors / m_numErrors, "m");
  }
}

void CTransportLog::PutBackDelivered() {
  for (CCylinderEntity* object : m_objects) {
    CEmbodiedEntity& body = object->GetEmbodiedEntity();
    if (body.GetOriginAnchor().Position.GetY() >= m_nest || IsHeld(*object)) {
      continue;
    }
    bool isBack = false;
    for (UInt32 i = 0; i < kTrials && !isBack; ++i) {
      const CVector2 offset(m_radius * Sqrt(m_rng->Uniform(CRange<Real>(0.0, 1.0))),
                            m_rng->Uniform(CRadians::UNSIGNED_RANGE));
      isBack = body.MoveTo(CVector3(offset.GetX(), m_source + offset.GetY(), 0.0), CQuaternion());
    }
    if (isBack) {
      ++m_delivered;
      m_deliveries.push_back(GetSpace().GetSimulationClock());
    }
  }
}

bool CTransportLog::IsHeld(const CCylinderEntity& object) const {
  for (const SRobot& robot : m_robots) {
    CGripperEquippedEntity& gripper = robot.Entity->GetGripperEquippedEntity();
    if (gripper.IsGripping() && &gripper.GetGrippedEntity() == &object.GetEmbodiedEntity()) {
      return true;
    }
  }
  return false;
}

void CTransportLog::Follow(SRobot& robot) {
  const CTransporter& controller = *robot.Controller;
  if (controller.GetNumGrips() != robot.NumGrips) {
    robot.NumGrips = controller.GetNumGrips();
    robot.Place = PlaceOf(*robot.Entity);
    robot.Heading = HeadingOf(*robot.Entity);
  }
  if (controller.GetNumArrivals() != robot.NumArrivals) {
    robot.NumArrivals = controller.GetNumArrivals();
    CVector2 way = PlaceOf(*robot.Entity) - robot.Place;
    const CVector2 error = way.Rotate(-robot.Heading) - controller.GetBelief() * kMeters;
    m_sumOfErrors += error.Length();
    ++m_numErrors;
    m_file << GetSpace().GetSimulationClock() << ',' << robot.Entity->GetId() << ',' << error.GetX()
           << ',' << error.GetY() << '\n';
  }
}

REGISTER_LOOP_FUNCTIONS(CTransportLog, "transport_log")
