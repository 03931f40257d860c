#include <argos3/core/simulator/visualization/drawing_functions.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/existing_component.h>
#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/simulator/geometry/pose_grid.h>
#include <argos3/core/utility/non_copyable.h>

namespace argos {

namespace {

void SetFrameOf(CEntity& entity, CDrawing& drawing) {
  if (auto* composable = dynamic_cast<CComposableEntity*>(&entity)) {
    if (auto* body = FindExistingComponent<CEmbodiedEntity>(*composable)) {
      const SBodyPose origin = SnapToPoseGrid(body->GetOriginAnchor());
      drawing.SetFrame(origin.Position, origin.Orientation);
      return;
    }
  } else if (auto* positional = dynamic_cast<CPositionalEntity*>(&entity)) {
    drawing.SetFrame(SnapToPoseGrid(positional->GetPosition()),
                     SnapToPoseGrid(positional->GetOrientation()));
    return;
  }
  drawing.SetWorldFrame();
}

thread_local CDrawing* g_currentDrawing = nullptr;
thread_local UInt64 g_numHooks = 0;

// points to a drawing during its lifetime
class CDrawingScope : private CNonCopyable {
 public:
  CDrawingScope(CDrawing*& pointer, CDrawing& drawing) : m_pointer(pointer) {
    m_pointer = g_currentDrawing = &drawing;
  }
  ~CDrawingScope() { m_pointer = g_currentDrawing = nullptr; }

 private:
  CDrawing*& m_pointer;
};

}  // namespace

CDrawingFunctions::CDrawingFunctions() = default;
CDrawingFunctions::~CDrawingFunctions() = default;

void CDrawingFunctions::Register(size_t tag, TFunction function) {
  if (m_functions.size() <= tag) {
    m_functions.resize(tag + 1);
  }
  m_functions[tag] = std::move(function);
}

bool CDrawingFunctions::HasFunctionFor(CEntity& entity) const {
  const size_t tag = entity.GetTag();
  return tag < m_functions.size() && m_functions[tag] != nullptr;
}

void CDrawingFunctions::Call(CEntity& entity) {
  if (HasFunctionFor(entity)) {
    m_functions[entity.GetTag()](entity);
  }
}

CDrawing& CDrawingFunctions::GetDrawing() {
  if (m_drawing == nullptr) {
    THROW_ARGOSEXCEPTION(
        "Functions that draw can be called only in hooks that draw: in a function registered for a "
        "class of entities, in DrawInWorld(), and in that of the overlay");
  }
  return *m_drawing;
}

CDrawing* CDrawingFunctions::GetCurrentDrawing() {
  return g_currentDrawing;
}

UInt64 CDrawingFunctions::GetNumHooks() {
  return g_numHooks;
}

void CDrawingFunctions::DrawAll(CDrawing& drawing, const CEntity::TVector& roots) {
  const CDrawingScope scope(m_drawing, drawing);
  if (!m_functions.empty()) {
    for (CEntity* root : roots) {
      if (HasFunctionFor(*root)) {
        SetFrameOf(*root, drawing);
        ++g_numHooks;
        Call(*root);
      }
    }
  }
  drawing.SetWorldFrame();
  ++g_numHooks;
  DrawInWorld();
  drawing.SetOverlay();
  ++g_numHooks;
  DrawInOverlay();
}

}  // namespace argos
