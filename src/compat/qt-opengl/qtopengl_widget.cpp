#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_widget.h>

#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_user_functions.h>

namespace argos {

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
