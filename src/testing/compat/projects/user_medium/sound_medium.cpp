#include "sound_medium.h"

#include <argos3/core/utility/logging/argos_log.h>

#include <algorithm>

#include "speaker_entity.h"

namespace argos {

void CSoundMedium::Init(TConfigurationNode& t_tree) {
  CMedium::Init(t_tree);
  GetNodeAttributeOrDefault(t_tree, "delay", m_unDelay, m_unDelay);
}

void CSoundMedium::PostSpaceInit() {
  LOG << "speakers " << m_vecSpeakers.size() << std::endl;
}

void CSoundMedium::Reset() {
  m_vecHistory.clear();
}

void CSoundMedium::Destroy() {
  m_vecSpeakers.clear();
  m_vecHistory.clear();
}

void CSoundMedium::AddEntity(CSpeakerEntity& c_entity) {
  m_vecSpeakers.push_back(&c_entity);
}

void CSoundMedium::RemoveEntity(CSpeakerEntity& c_entity) {
  m_vecSpeakers.erase(std::remove(m_vecSpeakers.begin(), m_vecSpeakers.end(), &c_entity),
                      m_vecSpeakers.end());
}

void CSoundMedium::Update() {
  std::vector<SSource> vecSources;
  for (size_t i = 0; i < m_vecSpeakers.size(); ++i) {
    SSource sSource = {m_vecSpeakers[i]->GetPosition(), m_vecSpeakers[i]->GetVolume()};
    vecSources.push_back(sSource);
  }
  m_vecHistory.push_back(vecSources);
  if (m_vecHistory.size() > m_unDelay + 1) {
    m_vecHistory.erase(m_vecHistory.begin());
  }
}

Real CSoundMedium::GetLoudnessAt(const CVector3& c_position) const {
  Real fSum = 0.0;
  if (m_vecHistory.size() > m_unDelay) {
    const std::vector<SSource>& vecSources = m_vecHistory.front();
    for (size_t i = 0; i < vecSources.size(); ++i) {
      fSum += vecSources[i].Volume / SquareDistance(vecSources[i].Position, c_position);
    }
  }
  return fSum;
}

REGISTER_MEDIUM(CSoundMedium, "sound", "A researcher", "1.0", "Carries sound.",
                "Sound falls off with the square of the distance.", "Usable");

}  // namespace argos
