#include "sound_medium.h"

#include <algorithm>

using namespace argos;

void CSoundMedium::Init(TConfigurationNode& node) {
  CMedium::Init(node);
  GetNodeAttributeOrDefault(node, "range", m_range, m_range);
}

void CSoundMedium::Update() {
  m_sources.clear();
  for (const SHorn* horn : m_horns) {
    if (horn->Volume > 0.0) {
      m_sources.push_back({horn->Body, horn->Body->GetOriginAnchor().Position, horn->Volume});
    }
  }
}

void CSoundMedium::Remove(const SHorn& horn) {
  m_horns.erase(std::remove(m_horns.begin(), m_horns.end(), &horn), m_horns.end());
}

Real CSoundMedium::ComputeLoudness(const CEmbodiedEntity& listener) const {
  const CVector3& place = listener.GetOriginAnchor().Position;
  Real sum = 0.0;
  for (const SSource& source : m_sources) {
    const Real squareDistance = SquareDistance(source.Position, place);
    if (source.Body != &listener && squareDistance <= m_range * m_range) {
      sum += source.Volume / (1.0 + squareDistance);
    }
  }
  return sum;
}

REGISTER_MEDIUM(CSoundMedium, "sound", "A. Student", "1.0", "Carries the sound of horns.",
                "  range  m, default 2: how far horns are heard.", "Usable")
