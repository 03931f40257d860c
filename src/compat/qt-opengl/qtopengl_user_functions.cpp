#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_user_functions.h>

#include <argos3/plugins/simulator/visualizations/qt-opengl/qt_conversions.h>

#include <cctype>
#include <map>

namespace argos {

namespace {

// the default of vertices: a circle that was meant to be round
constexpr GLuint kRoundVertices = 20;

// of Qt::Key, for a name of browsers; those of characters are their codes, of letters in upper case
int ToQtKey(const std::string& key) {
  static const std::map<std::string, int> named = {{"Escape", Qt::Key_Escape},
                                                   {"Tab", Qt::Key_Tab},
                                                   {"Backspace", Qt::Key_Backspace},
                                                   {"Enter", Qt::Key_Return},
                                                   {"Insert", Qt::Key_Insert},
                                                   {"Delete", Qt::Key_Delete},
                                                   {"Home", Qt::Key_Home},
                                                   {"End", Qt::Key_End},
                                                   {"ArrowLeft", Qt::Key_Left},
                                                   {"ArrowUp", Qt::Key_Up},
                                                   {"ArrowRight", Qt::Key_Right},
                                                   {"ArrowDown", Qt::Key_Down},
                                                   {"PageUp", Qt::Key_PageUp},
                                                   {"PageDown", Qt::Key_PageDown},
                                                   {"Shift", Qt::Key_Shift},
                                                   {"Control", Qt::Key_Control},
                                                   {"Meta", Qt::Key_Meta},
                                                   {"Alt", Qt::Key_Alt},
                                                   {"F1", Qt::Key_F1},
                                                   {"F2", Qt::Key_F2},
                                                   {"F3", Qt::Key_F3},
                                                   {"F4", Qt::Key_F4}};
  if (key.size() == 1) {
    return std::toupper(static_cast<unsigned char>(key[0]));
  }
  const auto found = named.find(key);
  return found == named.end() ? 0 : found->second;
}

Qt::KeyboardModifiers ToQtModifiers(const SViewKey& key) {
  return Qt::KeyboardModifiers()
      .setFlag(Qt::ShiftModifier, key.HasShift)
      .setFlag(Qt::ControlModifier, key.HasControl)
      .setFlag(Qt::AltModifier, key.HasAlt)
      .setFlag(Qt::MetaModifier, key.HasMeta);
}

}  // namespace

CQTOpenGLUserFunctions::CQTOpenGLUserFunctions()
    : m_ownMainWindow(*this), m_mainWindow(&m_ownMainWindow) {
  RegisterUserFunction<CQTOpenGLUserFunctions, CFloorEntity>(&CQTOpenGLUserFunctions::Draw);
}

void CQTOpenGLUserFunctions::KeyPressed(QKeyEvent* event) {
  GetQTOpenGLWidget().KeyPressed(event);
}

void CQTOpenGLUserFunctions::KeyReleased(QKeyEvent* event) {
  GetQTOpenGLWidget().KeyReleased(event);
}

void CQTOpenGLUserFunctions::HandleSelection(CEntity* root) {
  if (root != nullptr) {
    SelectEntity(*root);
  } else {
    DeselectEntity();
  }
}

void CQTOpenGLUserFunctions::ForgetSelection() {
  GetQTOpenGLWidget().ForgetSelection();
}

void CQTOpenGLUserFunctions::HandleMove(CEntity& root, const SBodyPose& before,
                                        const SBodyPose& now) {
  if (!(before.Position == now.Position)) {
    EntityMoved(root, before.Position, now.Position);
  }
  if (!(before.Orientation == now.Orientation)) {
    EntityRotated(root, before.Orientation, now.Orientation);
  }
}

bool CQTOpenGLUserFunctions::HandleKey(const SViewKey& key) {
  QKeyEvent event(ToQtKey(key.Name), key.Name.size() == 1 ? QString(key.Name) : QString(),
                  ToQtModifiers(key));
  if (key.IsDown) {
    KeyPressed(&event);
  } else {
    KeyReleased(&event);
  }
  return event.isAccepted();
}

CEntity* CQTOpenGLUserFunctions::GetSelectedEntity() {
  return GetQTOpenGLWidget().GetSelectedEntity();
}

void CQTOpenGLUserFunctions::SelectEntity(CEntity& entity) {
  GetQTOpenGLWidget().SelectEntity(entity);
}

void CQTOpenGLUserFunctions::DeselectEntity() {
  GetQTOpenGLWidget().DeselectEntity();
}

void CQTOpenGLUserFunctions::DrawInOverlay() {
  QPainter painter(GetDrawing());
  DrawOverlay(painter);
}

void CQTOpenGLUserFunctions::SetColor(const CColor& color) {
  SetGlColorBytes(color.GetRed(), color.GetGreen(), color.GetBlue(), color.GetAlpha());
}

void CQTOpenGLUserFunctions::DrawPoint(const CVector3& position, const CColor& color,
                                       Real diameter) {
  GetDrawing().DrawPoint(position, color, diameter);
}

void CQTOpenGLUserFunctions::DrawTriangle(const CVector3& position, const CQuaternion& orientation,
                                          Real base, Real height, const CColor& color, bool fill) {
  GetDrawing().DrawTriangle(position, orientation, base, height, color, fill);
}

void CQTOpenGLUserFunctions::DrawPolygon(const CVector3& position, const CQuaternion& orientation,
                                         const std::vector<CVector2>& corners, const CColor& color,
                                         bool fill) {
  GetDrawing().DrawPolygon(position, orientation, corners, color, fill);
}

void CQTOpenGLUserFunctions::DrawCircle(const CVector3& position, const CQuaternion& orientation,
                                        Real radius, const CColor& color, bool fill,
                                        GLuint vertices) {
  GetDrawing().DrawCircle(position, orientation, radius, color, fill,
                          vertices < kRoundVertices ? vertices : 0);
}

void CQTOpenGLUserFunctions::DrawCylinder(const CVector3& position, const CQuaternion& orientation,
                                          Real radius, Real height, const CColor& color,
                                          GLuint /*vertices*/) {
  GetDrawing().DrawCylinder(position, orientation, radius, height, color);
}

void CQTOpenGLUserFunctions::DrawBox(const CVector3& position, const CQuaternion& orientation,
                                     const CVector3& size, const CColor& color) {
  GetDrawing().DrawBox(position, orientation, size, color);
}

void CQTOpenGLUserFunctions::DrawRay(const CRay3& ray, const CColor& color, Real width) {
  GetDrawing().DrawLine(ray.GetStart(), ray.GetEnd(), color, width);
}

void CQTOpenGLUserFunctions::DrawText(const CVector3& position, const std::string& text,
                                      const CColor& color, const QFont& font) {
  GetDrawing().DrawText(position, text, color, ToTextStyle(font));
}

}  // namespace argos
