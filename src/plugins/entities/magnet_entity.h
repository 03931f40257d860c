#ifndef ARGOS3_PLUGINS_ENTITIES_MAGNET_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_MAGNET_ENTITY_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

/**
 * A permanent magnet, an electromagnet, or both: a dipole whose field is the sum of a passive field
 * and an active field times the current.
 *
 * Only stores the field; physics engines compute the forces between magnets.
 */
class CMagnetEntity : public CEntity {
 public:
  ENABLE_VTABLE();

  explicit CMagnetEntity(CComposableEntity* parent);
  /** @param passiveField, activeField  see GetField(). */
  CMagnetEntity(CComposableEntity* parent, const std::string& id, const CVector3& passiveField,
                const CVector3& activeField = CVector3());

  /** Reads `passive_field`, and `active_field` (default 0). */
  void Init(TConfigurationNode& tree) override;
  /** Sets the current to 0. */
  void Reset() override;
  std::string GetTypeDescription() const override { return "magnet"; }

  /** passive field + current * active field: dipole moment in the frame of the magnet's body. */
  CVector3 GetField() const { return m_passiveField + m_activeField * m_current; }
  const CVector3& GetPassiveField() const { return m_passiveField; }
  void SetPassiveField(const CVector3& field) {
    CRobotsCode::CheckOwn(*this, "SetPassiveField()");
    KeepForReset(m_passiveField);
    m_passiveField = field;
  }
  const CVector3& GetActiveField() const { return m_activeField; }
  void SetActiveField(const CVector3& field) {
    CRobotsCode::CheckOwn(*this, "SetActiveField()");
    KeepForReset(m_activeField);
    m_activeField = field;
  }
  Real GetCurrent() const { return m_current; }
  /**
   * @param current  in units of the active field's current. @throws CARGoSException if not finite.
   */
  void SetCurrent(Real current);

  void UpdateDigest(CDigest& digest) const override;

 private:
  CVector3 m_passiveField;
  CVector3 m_activeField;
  Real m_current = 0.0;
};

}  // namespace argos

#endif
