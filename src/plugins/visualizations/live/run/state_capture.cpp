#include <argos3/plugins/simulator/visualizations/live/run/state_capture.h>

#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/plugins/simulator/outputs/recording/format/drawing_coding.h>

namespace argos {

void CStateCapture::Init(TConfigurationNode& tree) {
  GetNodeAttributeOrDefault(tree, "drawing_width", m_width, m_width);
  GetNodeAttributeOrDefault(tree, "drawing_height", m_height, m_height);
  m_drawing.Init(tree);
}

void CStateCapture::Take(CSimulator& simulator, SLiveState& state) {
  CSpace& space = simulator.GetSpace();
  SFrameUpdate& update = state.Update;
  m_capture.Take(space, update);
  TakeMetrics(space, update);
  CByteWriter out(update.Drawing);
  WriteDrawing(m_drawing.Draw(simulator, m_width, m_height), out);
  if (!m_table.Apply(update).IsEmpty || m_shared == nullptr) {
    m_shared =
        std::make_shared<const SLiveTable>(SLiveTable{m_table.GetTypes(), m_table.GetEntities()});
  }
  update.IsRestart = false;
  update.NewTypes.clear();
  update.Removed.clear();
  update.Added.clear();
  state.Table = m_shared;
  state.Number = ++m_numStates;
}

}  // namespace argos
