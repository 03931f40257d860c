#ifndef ARGOS3_PLUGINS_OUTPUTS_RECORDING_TRACKED_ENTITY_H
#define ARGOS3_PLUGINS_OUTPUTS_RECORDING_TRACKED_ENTITY_H

#include <argos3/plugins/simulator/outputs/recording/format/recorded_frame.h>

#include <sys/types.h>

#include <vector>

namespace argos {

class CComposableEntity;
class CControllableEntity;
class CDirectionalLEDEquippedEntity;
class CEntity;
class CLEDEquippedEntity;
class CLightEntity;
class CPositionalEntity;
struct SAnchor;

/** A root entity of the space, with all that is looked up once to read its state in each tick. */
class CTrackedEntity {
 public:
  explicit CTrackedEntity(CEntity& root);

  /** @return true if it is this entity, and not another one at the same place in memory. */
  bool Is(const CEntity& root) const;
  /** @return true if components or LEDs were added: a new CTrackedEntity must then replace it. */
  bool HasNewParts() const;
  /** What recordings keep once for all entities that have it in common. */
  SRecordedType MakeType() const;
  /** @return true if both certainly have equal types; both must be in the space. */
  bool IsLike(const CTrackedEntity& other) const;

  CControllableEntity* GetRobot() const { return m_robot; }
  UInt32 GetType() const { return m_type; }
  void SetType(UInt32 type) { m_type = type; }

  /** Prefetches what Is() and HasNewParts() read; PrepareRead(), what the functions below read. */
  void PrepareCheck() const;
  void PrepareRead() const;
  /** Prefetches the colours of LEDs. The entity itself must be there, after PrepareRead(). */
  void PrepareColors() const;
  void AppendPoses(std::vector<SBodyPose>& poses) const;
  void AppendWords(std::vector<UInt32>& words) const;
  /** @param number  of the entity. */
  void AppendRays(UInt32 number, std::vector<SRecordedRay>& rays) const;

 private:
  void FindParts(CComposableEntity& entity);
  UInt32 CountLEDs() const;
  void FindAnchors();

  CEntity* m_root;
  ssize_t m_index;
  const SAnchor* m_origin = nullptr;  // null: no body
  CControllableEntity* m_robot = nullptr;  // null: none
  const CLEDEquippedEntity* m_leds = nullptr;  // null: none
  // null: none, or there are others, which views show
  const CDirectionalLEDEquippedEntity* m_directionalLEDs = nullptr;
  UInt32 m_type = 0;  // number in the recording
  SRecordedType::EKind m_kind = SRecordedType::EKind::Other;
  UInt32 m_numLEDs = 0;
  size_t m_numComponents = 0;
  std::vector<const SAnchor*> m_anchors;  // parts of the appearance are mounted on these
  const CComposableEntity* m_composable = nullptr;  // null: none
  const CPositionalEntity* m_place = nullptr;  // null: has a body, or no pose
  const CLightEntity* m_light = nullptr;  // null: none
};

}  // namespace argos

#endif
