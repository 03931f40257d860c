#ifndef ARGOS3_PLUGINS_ENTITIES_CYLINDER_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_CYLINDER_ENTITY_H

#include <argos3/plugins/simulator/entities/passive_body_entity.h>

namespace argos {

/** An upright cylinder: a fixed obstacle or a movable object. */
class CCylinderEntity : public CPassiveBodyEntity {
 public:
  ENABLE_VTABLE();

  CCylinderEntity();
  /**
   * @param position, orientation  of the centre of the base, m, world frame.
   * @param radius, height         m, > 0.
   * @param mass                   kg, > 0; ignored if not movable.
   * @throws CARGoSException if a size, or the mass of a movable cylinder, is not > 0.
   */
  CCylinderEntity(const std::string& id, const CVector3& position, const CQuaternion& orientation,
                  bool movable, Real radius, Real height, Real mass = 1.0);

  /** Reads `radius`, `height`, `movable`, `mass` (if movable), `<body>` and `<leds>` (optional). */
  void Init(TConfigurationNode& tree) override;
  std::string GetTypeDescription() const override { return "cylinder"; }

  /** m. */
  Real GetRadius() const { return m_radius; }
  Real GetHeight() const { return m_height; }
  /** Changes the size, m; see SetMass(). @throws CARGoSException if a value is not > 0. */
  void Resize(Real radius, Real height);

 protected:
  SShapeDescription MakeShape() const override {
    return SShapeDescription::Cylinder(m_radius, m_height);
  }
  SGroundFrictionDescription::EClass GetFrictionClass() const override {
    return SGroundFrictionDescription::EClass::Cylinder;
  }

 private:
  Real m_radius = 0.0;  // m
  Real m_height = 0.0;  // m
};

}  // namespace argos

#endif
