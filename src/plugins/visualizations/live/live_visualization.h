#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_LIVE_VISUALIZATION_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_LIVE_VISUALIZATION_H

#include <argos3/plugins/simulator/visualizations/live/live_engine.h>

#include <memory>

namespace argos {

/** The live view, `<live>`: loads the library that serves it, and passes everything on. */
class CLiveVisualization : public CVisualization {
 public:
  CLiveVisualization();
  ~CLiveVisualization() override;

  /** @throws CARGoSException if the library is missing: the text says what to install. */
  void Init(TConfigurationNode& tree) override;
  void Reset() override;
  void Destroy() override;
  void Execute() override;

 private:
  std::unique_ptr<CLiveEngine> m_engine;
};

}  // namespace argos

#endif
