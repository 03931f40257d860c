#include "trajectory_user_functions.h"

#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/datatypes/any.h>
#include <argos3/plugins/simulator/entities/light_entity.h>

#include "trajectory_loop_functions.h"

using namespace argos;

namespace {

const CColor kTrail(24, 112, 196);
const CColor kHeading(232, 96, 24);
const CColor kText(28, 34, 44);
constexpr Real kAboveGround = 0.01;  // m
constexpr Real kTrailWidth = 2.5;  // pixels
constexpr size_t kTicksPerSegment = 4;

}  // namespace

CTrajectoryUserFunctions::CTrajectoryUserFunctions()
    : m_loopFunctions(
          dynamic_cast<CTrajectoryLoopFunctions&>(CSimulator::GetInstance().GetLoopFunctions())) {
  RegisterUserFunction<CTrajectoryUserFunctions, CFootBotEntity>(&CTrajectoryUserFunctions::Draw);
}

// in the robot's frame: x ahead, z up
void CTrajectoryUserFunctions::Draw(CFootBotEntity& robot) {
  DrawTriangle(CVector3(0.15, 0.0, kAboveGround), CQuaternion(), 0.07, 0.09, kHeading);
  DrawText(CVector3(0.0, 0.0, 0.3), robot.GetId(), kText, QFont("Sans", 11));
}

void CTrajectoryUserFunctions::DrawInWorld() {
  for (const auto& [id, trajectory] : m_loopFunctions.GetTrajectories()) {
    for (size_t end = kTicksPerSegment; end < trajectory.size(); end += kTicksPerSegment) {
      CColor color = kTrail;
      color.SetAlpha(static_cast<UInt8>(255 * end / trajectory.size()));
      CVector3 from = trajectory[end - kTicksPerSegment];
      CVector3 to = trajectory[end];
      from.SetZ(kAboveGround);
      to.SetZ(kAboveGround);
      DrawRay(CRay3(from, to), color, kTrailWidth);
    }
  }
  // the target
  for (const auto& [id, entity] : CSimulator::GetInstance().GetSpace().GetEntitiesByType("light")) {
    CVector3 place = any_cast<CLightEntity*>(entity)->GetPosition();
    place.SetZ(kAboveGround);
    DrawCircle(place, CQuaternion(), 0.3, CColor(240, 196, 32, 70));
    DrawCircle(place, CQuaternion(), 0.3, CColor(176, 132, 0), false);
    DrawText(place + CVector3(0.34, 0.0, 0.0), "target", kText, QFont("Sans", 12, QFont::Bold));
  }
}

void CTrajectoryUserFunctions::DrawOverlay(QPainter& painter) {
  const CSimulator& simulator = CSimulator::GetInstance();
  painter.fillRect(16, 16, 116, 40, QColor(255, 255, 255, 200));
  painter.setPen(QColor(28, 34, 44));
  painter.setFont(QFont("Sans", 15));
  painter.drawText(
      28, 43,
      "tick " + QString::number(static_cast<int>(simulator.GetSpace().GetSimulationClock())));
}

REGISTER_QTOPENGL_USER_FUNCTIONS(CTrajectoryUserFunctions, "trajectory_user_functions")
