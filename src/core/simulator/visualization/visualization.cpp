#include <argos3/core/simulator/visualization/visualization.h>

#include <argos3/core/simulator/context/current.h>

namespace argos {

// made by zero-argument factories: the base picks up the thread's simulator once, here
CVisualization::CVisualization() : m_cSimulator(CurrentSimulator()), m_cSpace(CurrentSpace()) {}

}  // namespace argos
