#ifndef ARGOS3_PLUGINS_ENTITIES_RFID_TAG_EQUIPPED_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_RFID_TAG_EQUIPPED_ENTITY_H

#include <argos3/plugins/simulator/entities/mounted_entities.h>
#include <argos3/plugins/simulator/entities/rfid_tag_entity.h>

#include <string>

namespace argos {

/** The RFID tags on a body. Starts disabled: the tags can then not be read. */
class CRFIDTagEquippedEntity : public CMountedEntities<CRFIDTagEntity> {
 public:
  ENABLE_VTABLE();

  using CMountedEntities::CMountedEntities;

  /**
   * Reads `medium` and the children `<rfid_tag id="..." position="x,y,z" anchor="origin"
   * memory="16" data="1,2" />`, and enables the tags. The parent must have a "body" with these
   * anchors.
   * @throws CARGoSException with the known names if a medium or an anchor is unknown.
   */
  void Init(TConfigurationNode& tree) override;
  std::string GetTypeDescription() const override { return "rfid_tags"; }

  /** @param position in the anchor's frame, m. @param data the memory; defines its size. */
  void AddTag(const std::string& id, const CVector3& position, SAnchor& anchor,
              const CByteArray& data);

  size_t GetNumTags() const { return GetInstances().size(); }
  /** @throws CARGoSException if the index is out of range. */
  CRFIDTagEntity& GetTag(UInt32 index) { return GetEntity(index, "RFID tag"); }
};

}  // namespace argos

#endif
