#ifndef ARGOS3_PLUGINS_ENTITIES_BOX_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_BOX_ENTITY_H

#include <argos3/plugins/simulator/entities/passive_body_entity.h>

namespace argos {

/** A box: a fixed obstacle or a movable object. */
class CBoxEntity : public CPassiveBodyEntity {
 public:
  ENABLE_VTABLE();

  CBoxEntity();
  /**
   * @param position, orientation  of the centre of the base, m, world frame.
   * @param size                   along the local axes, m, each > 0.
   * @param mass                   kg, > 0; ignored if not movable.
   * @throws CARGoSException if a size, or the mass of a movable box, is not > 0.
   */
  CBoxEntity(const std::string& id, const CVector3& position, const CQuaternion& orientation,
             bool movable, const CVector3& size, Real mass = 1.0);

  /** Reads `size`, `movable`, `mass` (if movable), `<body>` and `<leds>` (optional). */
  void Init(TConfigurationNode& tree) override;
  std::string GetTypeDescription() const override { return "box"; }

  /** Extents along the local axes, m. */
  const CVector3& GetSize() const { return m_size; }
  /** Changes the size; see SetMass(). @throws CARGoSException if an extent is not > 0. */
  void Resize(const CVector3& size);

 protected:
  SShapeDescription MakeShape() const override { return SShapeDescription::Box(m_size); }
  SGroundFrictionDescription::EClass GetFrictionClass() const override {
    return SGroundFrictionDescription::EClass::Box;
  }

 private:
  CVector3 m_size;  // m
};

}  // namespace argos

#endif
