#ifndef OWN_MEDIUM_SOUND_MEDIUM_H
#define OWN_MEDIUM_SOUND_MEDIUM_H

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/medium/medium.h>

#include <vector>

/** A horn on a robot, as the medium sees it; its actuator owns it. */
struct SHorn {
  const argos::CEmbodiedEntity* Body = nullptr;
  argos::Real Volume = 0.0;
};

/**
 * Carries the sound of horns: <sound id="air" range="2" />. The loudness of a horn at a distance d
 * is volume / (1 + d^2), and 0 beyond the range (m).
 */
class CSoundMedium : public argos::CMedium {
 public:
  void Init(argos::TConfigurationNode& node) override;
  /** Called once a tick, after physics and before robots sense. */
  void Update() override;
  void Reset() override { m_sources.clear(); }

  void Add(const SHorn& horn) { m_horns.push_back(&horn); }
  void Remove(const SHorn& horn);

  /** Sum over all horns but that of @p listener. Sensors call it from several threads. */
  argos::Real ComputeLoudness(const argos::CEmbodiedEntity& listener) const;

 private:
  struct SSource {
    const argos::CEmbodiedEntity* Body;
    argos::CVector3 Position;  // m
    argos::Real Volume;
  };

  argos::Real m_range = 2.0;  // m
  std::vector<const SHorn*> m_horns;  // not owned
  std::vector<SSource> m_sources;  // of this tick; written by Update(), read by sensors
};

#endif
