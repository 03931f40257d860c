#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_POVRAY_POVRAY_OUTPUT_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_POVRAY_POVRAY_OUTPUT_H

#include <argos3/core/simulator/outputs/run_output.h>
#include <argos3/core/simulator/visualization/view_drawing.h>

#include <memory>

namespace argos {

class CPovrayFrameSeries;

/** Writes scene files for POV-Ray, and renders them where it is installed: `<povray>`. */
class CPovrayOutput : public CRunOutput {
 public:
  CPovrayOutput();
  ~CPovrayOutput() override;

  /** @throws CARGoSException with file and line. */
  void Init(TConfigurationNode& tree) override;
  void Reset() override;
  void Destroy() override;
  /** @throws CARGoSException if a scene cannot be written or rendered. */
  void Observe(CSimulator& simulator) override;
  void Finish(CSimulator& simulator) override;

 private:
  CViewDrawing m_drawing;
  std::unique_ptr<CPovrayFrameSeries> m_series;  // null before Init() and after Destroy()
};

}  // namespace argos

#endif
