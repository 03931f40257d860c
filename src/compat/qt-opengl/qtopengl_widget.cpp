#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_widget.h>

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/simulator/physics_engine/physics_model.h>
#include <argos3/core/simulator/visualization/drawing.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_user_functions.h>

namespace argos {

void CQTOpenGLWidget::DrawEntity(CPositionalEntity& entity) {
  m_userFunctions.GetDrawing().SetFrame(entity.GetPosition(), entity.GetOrientation());
}

void CQTOpenGLWidget::DrawEntity(CEmbodiedEntity& body) {
  const SAnchor& origin = body.GetOriginAnchor();
  m_userFunctions.GetDrawing().SetFrame(origin.Position, origin.Orientation);
}

void CQTOpenGLWidget::DrawRays(CControllableEntity& entity) {
  constexpr Real kPointDiameter = 5.0;  // pixels
  if (!m_drawsRays) {
    return;
  }
  CDrawing& drawing = m_userFunctions.GetDrawing();
  drawing.SetWorldFrame();
  for (const auto& [isObstructed, ray] : entity.GetCheckedRays()) {
    drawing.DrawLine(ray.GetStart(), ray.GetEnd(), isObstructed ? CColor::MAGENTA : CColor::CYAN);
  }
  for (const CVector3& point : entity.GetIntersectionPoints()) {
    drawing.DrawPoint(point, CColor::BLACK, kPointDiameter);
  }
}

void CQTOpenGLWidget::DrawBoundingBox(CEmbodiedEntity& body) {
  constexpr Real kLineWidth = 3.0;  // pixels
  const SBoundingBox& box = body.GetBoundingBox();
  const auto corner = [&box](UInt32 bits) {
    return CVector3((bits & 1U) != 0 ? box.MaxCorner.GetX() : box.MinCorner.GetX(),
                    (bits & 2U) != 0 ? box.MaxCorner.GetY() : box.MinCorner.GetY(),
                    (bits & 4U) != 0 ? box.MaxCorner.GetZ() : box.MinCorner.GetZ());
  };
  CDrawing& drawing = m_userFunctions.GetDrawing();
  drawing.SetWorldFrame();
  for (UInt32 from = 0; from < 8; ++from) {
    for (UInt32 axis = 1; axis < 8; axis *= 2) {
      if ((from & axis) == 0) {
        drawing.DrawLine(corner(from), corner(from | axis), CColor::WHITE, kLineWidth);
      }
    }
  }
}

void CQTOpenGLWidget::SelectEntity(CEntity& entity) {
  if (m_selected == &entity) {
    return;
  }
  DeselectEntity();
  m_selected = &entity;
  m_userFunctions.EntitySelected(entity);
}

void CQTOpenGLWidget::DeselectEntity() {
  if (m_selected != nullptr) {
    CEntity& entity = *m_selected;
    m_selected = nullptr;
    m_userFunctions.EntityDeselected(entity);
  }
}

}  // namespace argos
