#ifndef ARGOS3_PLUGINS_ENTITIES_TAG_EQUIPPED_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_TAG_EQUIPPED_ENTITY_H

#include <argos3/plugins/simulator/entities/mounted_entities.h>
#include <argos3/plugins/simulator/entities/tag_entity.h>

#include <string>
#include <vector>

namespace argos {

/** A tag and its place. */
template <>
struct SMountedInstance<CTagEntity> {
  CTagEntity& Tag;
  CVector3 PositionOffset; /**< offset in the anchor's frame, m */
  CQuaternion OrientationOffset; /**< offset in the anchor's frame */
  SAnchor& Anchor;

  typedef std::vector<SMountedInstance> TVector;

  CTagEntity& GetEntity() const { return Tag; }
  const CVector3& GetPositionOffset() const { return PositionOffset; }
};

/** The tags on a body. Starts disabled. */
class CTagEquippedEntity : public CMountedEntities<CTagEntity> {
 public:
  ENABLE_VTABLE();

  using CMountedEntities::CMountedEntities;

  /**
   * Reads `medium` and the children `<tag position="x,y,z" orientation="z,y,x" anchor="..."
   * observable_angle="..." side_length="..." payload="..." />`, and enables the tags. The parent
   * must have a "body" with these anchors.
   * @throws CARGoSException with the known names if a medium or an anchor is unknown.
   */
  void Init(TConfigurationNode& tree) override;
  std::string GetTypeDescription() const override { return "tags"; }

  /**
   * Adds a tag in the xy plane of its frame, readable from the side of the positive z axis.
   * @param id                     unique among the tags of this entity.
   * @param position, orientation  of the tag's frame in the anchor's frame, m.
   * @param observableAngle        half angle of the readability cone, in (0, PI].
   * @param sideLength             m, > 0.
   */
  void AddTag(const std::string& id, const CVector3& position, const CQuaternion& orientation,
              SAnchor& anchor, const CRadians& observableAngle, Real sideLength,
              const std::string& payload = "");
  /** The same with the id tag_0, tag_1, ... */
  void AddTag(const CVector3& position, const CQuaternion& orientation, SAnchor& anchor,
              const CRadians& observableAngle, Real sideLength, const std::string& payload = "");

  size_t GetNumTags() const { return GetInstances().size(); }
  /** These throw CARGoSException if the index is out of range. */
  CTagEntity& GetTag(UInt32 index);
  const CTagEntity& GetTag(UInt32 index) const { return GetEntity(index, "tag"); }
  void SetTagPayload(UInt32 index, const std::string& payload);
  void SetTagPayloads(const std::string& payload);
  /** @throws CARGoSException if the numbers of payloads and of tags differ. */
  void SetTagPayloads(const std::vector<std::string>& payloads);
};

}  // namespace argos

#endif
