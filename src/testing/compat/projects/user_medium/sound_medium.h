#ifndef SOUND_MEDIUM_H
#define SOUND_MEDIUM_H

namespace argos {
class CSoundMedium;
class CSpeakerEntity;
}  // namespace argos

#include <argos3/core/simulator/medium/medium.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

/* Carries the sound of speakers: it falls off with the square of the distance, and is late by a
   number of ticks. */
class CSoundMedium : public CMedium {
 public:
  CSoundMedium() : m_unDelay(0) {}
  virtual ~CSoundMedium() {}
  virtual void Init(TConfigurationNode& t_tree);
  virtual void PostSpaceInit();
  virtual void Reset();
  virtual void Destroy();
  virtual void Update();
  void AddEntity(CSpeakerEntity& c_entity);
  void RemoveEntity(CSpeakerEntity& c_entity);
  Real GetLoudnessAt(const CVector3& c_position) const;

 private:
  struct SSource {
    CVector3 Position;
    Real Volume;
  };

  UInt32 m_unDelay;
  std::vector<CSpeakerEntity*> m_vecSpeakers;
  std::vector<std::vector<SSource> > m_vecHistory;
};

}  // namespace argos

#endif
