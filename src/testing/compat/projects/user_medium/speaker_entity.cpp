#include "speaker_entity.h"

#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>

#include "sound_medium.h"

namespace argos {

CSpeakerEntity::CSpeakerEntity() : CPositionalEntity(NULL), m_fVolume(0.0), m_fInitVolume(0.0) {}

void CSpeakerEntity::Init(TConfigurationNode& t_tree) {
  try {
    CPositionalEntity::Init(t_tree);
    GetNodeAttribute(t_tree, "volume", m_fInitVolume);
    m_fVolume = m_fInitVolume;
    std::string strMedium;
    GetNodeAttribute(t_tree, "medium", strMedium);
    CSimulator::GetInstance().GetMedium<CSoundMedium>(strMedium).AddEntity(*this);
  } catch (CARGoSException& ex) {
    THROW_ARGOSEXCEPTION_NESTED("Error while initializing speaker \"" << GetId() << "\"", ex);
  }
}

void CSpeakerEntity::Reset() {
  CPositionalEntity::Reset();
  m_fVolume = m_fInitVolume;
}

REGISTER_ENTITY(CSpeakerEntity, "speaker", "A researcher", "1.0", "A loudspeaker.",
                "Makes sound at a point.", "Usable");

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CSpeakerEntity);

}  // namespace argos
