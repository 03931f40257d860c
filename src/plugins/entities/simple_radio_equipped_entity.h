#ifndef ARGOS3_PLUGINS_ENTITIES_SIMPLE_RADIO_EQUIPPED_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_SIMPLE_RADIO_EQUIPPED_ENTITY_H

#include <argos3/plugins/simulator/entities/mounted_entities.h>
#include <argos3/plugins/simulator/entities/simple_radio_entity.h>

#include <string>
#include <vector>

namespace argos {

/** A radio and its place. */
template <>
struct SMountedInstance<CSimpleRadioEntity> {
  CSimpleRadioEntity& Radio;
  CVector3 Offset; /**< offset in the anchor's frame, m */
  CQuaternion OrientationOffset; /**< offset in the anchor's frame */
  SAnchor& Anchor;

  typedef std::vector<SMountedInstance> TVector;

  CSimpleRadioEntity& GetEntity() const { return Radio; }
  const CVector3& GetPositionOffset() const { return Offset; }
};

/** The radios on a body. Starts disabled. */
class CSimpleRadioEquippedEntity : public CMountedEntities<CSimpleRadioEntity> {
 public:
  ENABLE_VTABLE();

  using CMountedEntities::CMountedEntities;

  /**
   * Reads the children `<simple_radio id="..." medium="..." range="..." position="x,y,z"
   * anchor="origin" />`, and enables the radios. The parent must have a "body" with these anchors.
   * @throws CARGoSException with the known names if a medium or an anchor is unknown, or if two
   * radios have the same id.
   */
  void Init(TConfigurationNode& tree) override;
  std::string GetTypeDescription() const override { return "simple_radios"; }

  /**
   * @param id        unique among the radios of this entity.
   * @param position  in the anchor's frame, m.
   * @param medium    a CSimpleRadioMedium.
   * @param range     m, >= 0.
   * @throws CARGoSException if the id is in use.
   */
  void AddRadio(const std::string& id, const CVector3& position, SAnchor& anchor,
                CSimpleRadioEntity::CRegistry& medium, Real range);

  size_t GetNumRadios() const { return GetInstances().size(); }
  /** @throws CARGoSException if the index is out of range. */
  CSimpleRadioEntity& GetRadio(UInt32 index) { return GetEntity(index, "radio"); }

 private:
  void RequireNewId(const std::string& id) const;
};

}  // namespace argos

#endif
