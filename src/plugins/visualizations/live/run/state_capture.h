#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_STATE_CAPTURE_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_STATE_CAPTURE_H

#include <argos3/core/simulator/visualization/view_drawing.h>
#include <argos3/plugins/simulator/outputs/recording/capture.h>
#include <argos3/plugins/simulator/outputs/recording/format/entity_table.h>
#include <argos3/plugins/simulator/visualizations/live/link/live_messages.h>

#include <memory>

namespace argos {

class CSimulator;

/** Reads states of a run, between ticks. Changes nothing in it. */
class CStateCapture {
 public:
  /** Reads the size of the picture for code that draws, and what draws: see CViewDrawing. */
  void Init(TConfigurationNode& tree);
  void Destroy() { m_drawing.Destroy(); }

  const CViewDrawing& GetDrawing() const { return m_drawing; }

  /** To be called before the first tick and after each one. */
  void Observe(CSimulator& simulator) { m_drawing.Observe(simulator); }
  /** @param state  empty. */
  void Take(CSimulator& simulator, SLiveState& state);

 private:
  CViewDrawing m_drawing;
  UInt32 m_width = 1280;  // pixels
  UInt32 m_height = 960;
  CCapture m_capture;
  CEntityTable m_table;
  std::shared_ptr<const SLiveTable> m_shared;  // copy of m_table
  UInt64 m_numStates = 0;
};

}  // namespace argos

#endif
