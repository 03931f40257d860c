#ifndef ARGOS3_CORE_SIMULATOR_DEFAULT_VISUALIZATION_H
#define ARGOS3_CORE_SIMULATOR_DEFAULT_VISUALIZATION_H

#include <argos3/core/simulator/visualization/visualization.h>

namespace argos {

/** Shows nothing: the headless run. In real-time mode it keeps one tick per tick length. */
class CDefaultVisualization : public CVisualization {
 public:
  void Execute() override;

 private:
  void ExecuteAsFastAsPossible();
  void ExecuteInRealTime();
};

}  // namespace argos

#endif
