#include <argos3/plugins/simulator/entities/lights.h>

#include <algorithm>

namespace argos {

void CLights::Add(CLightEntity& light) {
  m_lights.push_back(&light);
}

void CLights::Remove(CLightEntity& light) {
  m_lights.erase(std::remove(m_lights.begin(), m_lights.end(), &light), m_lights.end());
}

}  // namespace argos
