#include <argos3/core/simulator/medium/medium.h>

#include <argos3/core/simulator/context/current.h>

namespace argos {

// media are made by zero-argument factories and by users' own code, so the base picks up the
// thread's simulator here, once, and derived classes use the members
CMedium::CMedium() : m_cSimulator(CurrentSimulator()), m_cSpace(CurrentSpace()) {}

void CMedium::Init(TConfigurationNode& tree) {
  GetNodeAttribute(tree, "id", m_id);
}

}  // namespace argos
