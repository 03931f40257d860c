#include <argos3/core/simulator/medium/medium.h>

#include <argos3/core/simulator/context/current.h>

namespace argos {

// zero-argument factories and users' code create media: the base class gets the thread's simulator
CMedium::CMedium() : m_cSimulator(CurrentSimulator()), m_cSpace(CurrentSpace()) {}

void CMedium::Init(TConfigurationNode& tree) {
  GetNodeAttribute(tree, "id", m_id);
}

}  // namespace argos
