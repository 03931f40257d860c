#include <argos3/core/simulator/view_drawing.h>

#include <argos3/core/simulator/loading/library_attribute.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/tick/loop_hooks.h>

namespace argos {

namespace {

constexpr char kElement[] = "user_functions";

std::unique_ptr<CDrawingFunctions> CreateFunctions(TConfigurationNode& node) {
  std::string label;
  try {
    GetNodeAttribute(node, "label", label);
    LoadLibraryOf(node);
    std::unique_ptr<CDrawingFunctions> functions(CFactory<CDrawingFunctions>::New(label));
    functions->Init(node);
    return functions;
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(node.GetLocation() << ": <" << kElement << " label=\"" << label
                                                   << "\">: nothing can be drawn by it",
                                error);
  }
}

}  // namespace

void CViewDrawing::Init(TConfigurationNode& view) {
  TConfigurationNodeIterator it(kElement);
  for (it = it.begin(&view); it != it.end(); ++it) {
    m_functions.push_back(CreateFunctions(*it));
  }
}

void CViewDrawing::Destroy() {
  while (!m_functions.empty()) {
    const std::unique_ptr<CDrawingFunctions> last = std::move(m_functions.back());
    m_functions.pop_back();
    last->Destroy();
  }
}

const CDrawing& CViewDrawing::Draw(CSimulator& simulator, UInt32 width, UInt32 height) {
  CSpace& space = simulator.GetSpace();
  const bool hasBeenReset = space.GetSimulationClock() < m_lastTick;
  m_lastTick = space.GetSimulationClock();
  m_drawing.Begin(width, height);
  for (const std::unique_ptr<CDrawingFunctions>& functions : m_functions) {
    if (hasBeenReset) {
      functions->Reset();
    }
    functions->DrawAll(m_drawing, space.GetRootEntityVector());
  }
  CLoopFunctions& loopFunctions = simulator.GetLoopFunctions();
  m_drawing.SetWorldFrame();
  CallHook(space.GetContext(), "DrawInWorld()", [&] { loopFunctions.DrawInWorld(m_drawing); });
  m_drawing.SetOverlay();
  CallHook(space.GetContext(), "DrawInOverlay()", [&] { loopFunctions.DrawInOverlay(m_drawing); });
  return m_drawing;
}

}  // namespace argos
