#ifndef ARGOS3_PLUGINS_ENTITIES_MAGNET_EQUIPPED_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_MAGNET_EQUIPPED_ENTITY_H

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/simulator/entities/magnet_entity.h>

#include <memory>
#include <string>
#include <vector>

namespace argos {

/** The magnets on a body. */
class CMagnetEquippedEntity : public CComposableEntity {
 public:
  ENABLE_VTABLE();

  /** A magnet and its place. */
  struct SInstance {
    CMagnetEntity& Magnet;
    CVector3 Offset; /**< offset in the anchor's frame, m */
    SAnchor& Anchor;

    typedef std::vector<SInstance> TVector;
  };

  explicit CMagnetEquippedEntity(CComposableEntity* parent);
  CMagnetEquippedEntity(CComposableEntity* parent, const std::string& id);

  /**
   * Reads the children `<magnet id="..." offset="x,y,z" anchor="..." passive_field="x,y,z"
   * active_field="x,y,z" />`. The parent must have a "body" with these anchors.
   * @throws CARGoSException with the known names if an anchor is unknown.
   */
  void Init(TConfigurationNode& tree) override;
  std::string GetTypeDescription() const override { return "magnets"; }
  /** Also enables or disables the use of the anchors. */
  void SetEnabled(bool enabled) override;

  /** @param offset in the anchor's frame, m. @param id empty: "magnet_<number>". */
  void AddMagnet(const std::string& id, const CVector3& offset, SAnchor& anchor,
                 const CVector3& passiveField, const CVector3& activeField = CVector3());

  size_t GetNumMagnets() const { return m_instances.size(); }
  /** @throws CARGoSException if the index is out of range. */
  CMagnetEntity& GetMagnet(UInt32 index);
  /** All magnets, in the order of addition. */
  SInstance::TVector& GetInstances() { return m_instances; }

 private:
  void Mount(std::unique_ptr<CMagnetEntity> magnet, const CVector3& offset, SAnchor& anchor);

  SInstance::TVector m_instances;
};

}  // namespace argos

#endif
