#ifndef ARGOS3_PLUGINS_ENTITIES_RFID_TAG_EQUIPPED_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_RFID_TAG_EQUIPPED_ENTITY_H

#include <argos3/plugins/simulator/entities/mounted_entities.h>
#include <argos3/plugins/simulator/entities/rfid_tag_entity.h>

#include <string>

namespace argos {

/** The RFID tags that a body carries. Starts disabled: then nobody reads them. */
class CRFIDTagEquippedEntity : public CMountedEntities<CRFIDTagEntity> {
 public:
  ENABLE_VTABLE();

  explicit CRFIDTagEquippedEntity(CComposableEntity* parent);
  CRFIDTagEquippedEntity(CComposableEntity* parent, const std::string& id);

  /**
   * Reads `medium` and the children `<rfid_tag id="..." position="x,y,z" anchor="origin"
   * memory="16" data="1,2" />`, and enables the tags. The parent must have a "body" with the
   * anchors named.
   * @throws CARGoSException with the known names if a medium or an anchor is unknown.
   */
  void Init(TConfigurationNode& tree) override;
  std::string GetTypeDescription() const override { return "rfid_tags"; }

  /** @param position in the anchor's frame, m. @param data the memory, and with that its size. */
  void AddTag(const std::string& id, const CVector3& position, SAnchor& anchor,
              const CByteArray& data);

  size_t GetNumTags() const { return GetInstances().size(); }
  /** @throws CARGoSException if there is no tag of that number. */
  CRFIDTagEntity& GetTag(UInt32 index) { return GetEntity(index, "RFID tag"); }
};

}  // namespace argos

#endif
