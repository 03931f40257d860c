#ifndef SPEAKER_ENTITY_H
#define SPEAKER_ENTITY_H

namespace argos {
class CSpeakerEntity;
}

#include <argos3/core/simulator/entity/positional_entity.h>

namespace argos {

/* <speaker id="s" position="3,4,0" orientation="0,0,0" volume="50" medium="sound" /> */
class CSpeakerEntity : public CPositionalEntity {
 public:
  ENABLE_VTABLE();
  CSpeakerEntity();
  virtual ~CSpeakerEntity() {}
  virtual void Init(TConfigurationNode& t_tree);
  virtual void Reset();
  virtual void Update() {}
  Real GetVolume() const { return m_fVolume; }
  void SetVolume(Real f_volume) { m_fVolume = f_volume; }
  virtual std::string GetTypeDescription() const { return "speaker"; }

 private:
  Real m_fVolume;
  Real m_fInitVolume;
};

}  // namespace argos

#endif
