#include <argos3/core/simulator/visualization/visualization.h>

#include <argos3/core/simulator/context/current.h>

namespace argos {

// zero-argument factories create visualizations: the base class gets the thread's simulator
CVisualization::CVisualization() : m_cSimulator(CurrentSimulator()), m_cSpace(CurrentSpace()) {}

}  // namespace argos
