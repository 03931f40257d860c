#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_LIVE_ENGINE_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_LIVE_ENGINE_H

#include <argos3/core/simulator/visualization/visualization.h>

namespace argos {

/**
 * Runs an experiment for CLiveVisualization. The classes are in a library that is loaded when one
 * is needed, so that other runs do not pay for it.
 */
class CLiveEngine : public CVisualization {};

}  // namespace argos

#define REGISTER_LIVE_ENGINE(CLASSNAME, LABEL)                                                 \
  REGISTER_SYMBOL(CLiveEngine, CLASSNAME, LABEL, "the authors of this project", "1.0", "", "", \
                  "Usable")

#endif
