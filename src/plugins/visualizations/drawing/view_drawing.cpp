#include <argos3/core/simulator/visualization/view_drawing.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/context/library_attribute.h>
#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/tick/loop_functions.h>
#include <argos3/core/simulator/tick/loop_hooks.h>
#include <argos3/core/utility/logging/argos_log.h>

namespace argos {

namespace {

// creates what an element describes; opening: the start of its tag, for errors
template <typename PART>
std::unique_ptr<PART> CreatePart(TConfigurationNode& node, const std::string& label,
                                 const std::string& opening) {
  try {
    LoadLibraryOf(node);
    std::unique_ptr<PART> part(CFactory<PART>::New(label));
    part->Init(node);
    return part;
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(
        node.GetLocation() << ": <" << opening << ">: nothing can be drawn by it", error);
  }
}

template <typename PART>
void DestroyParts(std::vector<std::unique_ptr<PART>>& parts) {
  while (!parts.empty()) {
    const std::unique_ptr<PART> last = std::move(parts.back());
    parts.pop_back();
    last->Destroy();
  }
}

}  // namespace

void CViewDrawing::Init(TConfigurationNode& view) {
  if (NodeExists(view, "overlays")) {
    TConfigurationNodeIterator overlay;
    for (overlay = overlay.begin(&GetNode(view, "overlays")); overlay != overlay.end(); ++overlay) {
      m_overlays.push_back(CreatePart<COverlay>(*overlay, overlay->Value(), overlay->Value()));
    }
  }
  if (CurrentContext().IsReplay && NodeExists(view, "user_functions")) {
    LOGERR << "[WARNING] " << view.GetLocation() << ": <" << view.Value()
           << ">: <user_functions> draw nothing in a replay, which has none of users' code; "
              "<recording "
           << "drawing=\"true\"> records what they draw" << std::endl;
    MarkSubtreeRead(view);
    return;
  }
  TConfigurationNodeIterator it("user_functions");
  for (it = it.begin(&view); it != it.end(); ++it) {
    std::string label;
    GetNodeAttribute(*it, "label", label);
    m_functions.push_back(
        CreatePart<CDrawingFunctions>(*it, label, it->Value() + " label=\"" + label + "\""));
  }
}

void CViewDrawing::Destroy() {
  DestroyParts(m_functions);
  DestroyParts(m_overlays);
}

void CViewDrawing::ForEachFunctions(const std::function<void(CDrawingFunctions&)>& call) const {
  for (const std::unique_ptr<CDrawingFunctions>& functions : m_functions) {
    call(*functions);
  }
}

void CViewDrawing::NoticeReset(CSimulator& simulator) {
  const UInt32 tick = simulator.GetSpace().GetSimulationClock();
  if (tick < m_lastTick) {
    for (const std::unique_ptr<COverlay>& overlay : m_overlays) {
      overlay->Reset();
    }
    for (const std::unique_ptr<CDrawingFunctions>& functions : m_functions) {
      functions->Reset();
    }
  }
  m_lastTick = tick;
}

void CViewDrawing::Observe(CSimulator& simulator) {
  NoticeReset(simulator);
  for (const std::unique_ptr<COverlay>& overlay : m_overlays) {
    overlay->Observe(simulator);
  }
}

const CDrawing& CViewDrawing::Draw(CSimulator& simulator, UInt32 width, UInt32 height) {
  NoticeReset(simulator);
  CSpace& space = simulator.GetSpace();
  m_drawing.Begin(width, height);
  for (const std::unique_ptr<COverlay>& overlay : m_overlays) {
    m_drawing.SetWorldFrame();
    overlay->Draw(simulator, m_drawing);
  }
  for (const std::unique_ptr<CDrawingFunctions>& functions : m_functions) {
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
