#ifndef ARGOS3_PLUGINS_ENTITIES_DIRECTIONAL_LED_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_DIRECTIONAL_LED_ENTITY_H

#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/utility/datatypes/color.h>
#include <argos3/core/utility/datatypes/set.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/simulator/entities/cell_updaters.h>
#include <argos3/plugins/simulator/entities/medium_member.h>
#include <argos3/plugins/simulator/entities/observable.h>

#include <vector>

namespace argos {

class CDirectionalLEDMedium;

/**
 * A point light that shines along its z axis and is visible within an angle around it.
 *
 * Starts disabled. The medium contains it exactly while it is enabled.
 */
class CDirectionalLEDEntity : public CMediumMember<CDirectionalLEDEntity, CDirectionalLEDMedium> {
 public:
  ENABLE_VTABLE();

  typedef std::vector<CDirectionalLEDEntity*> TList;
  typedef CSet<CDirectionalLEDEntity*, SEntityComparator> TSet;

  /** Creates a black LED that is visible from all sides. */
  explicit CDirectionalLEDEntity(CComposableEntity* parent);
  /**
   * @param position, orientation  m, world frame.
   * @param observableAngle        see SetObservableAngle().
   */
  CDirectionalLEDEntity(CComposableEntity* parent, const std::string& id, const CVector3& position,
                        const CQuaternion& orientation, const CRadians& observableAngle,
                        const CColor& color);
  ~CDirectionalLEDEntity() override;

  /** Reads `observable_angle`, `color` (default black), and the pose. */
  void Init(TConfigurationNode& tree) override;
  /** Restores the initial colour and pose. */
  void Reset() override;
  std::string GetTypeDescription() const override { return "directional_led"; }

  const CColor& GetColor() const { return m_color; }
  /** By code of its own robot: takes effect when all robots have been controlled (CRobotsCode). */
  void SetColor(const CColor& color) {
    if (CRobotsCode::ChangesLater(*this, "SetColor()", [this, color] { SetColor(color); })) {
      return;
    }
    m_color = color;
  }
  const CColor& GetInitColor() const { return m_initColor; }
  void SetInitColor(const CColor& color) { m_initColor = color; }
  /** @return false if the colour is opaque black: such an LED is invisible to cameras. */
  bool IsLit() const { return m_color != CColor(); }
  /** Hides that of CMediumMember. */
  bool IsInCells() const { return IsLit(); }

  const CRadians& GetObservableAngle() const { return m_cone.GetAngle(); }
  /**
   * @param angle  half angle of the visibility cone around the z axis, in (0, PI].
   * @throws CARGoSException if the angle is out of range.
   */
  void SetObservableAngle(const CRadians& angle);
  /** @return true if a point (m, world frame) is in the visibility cone. */
  bool ShinesOn(const CVector3& point) const { return m_cone.Contains(*this, point); }

  void UpdateDigest(CDigest& digest) const override;

 private:
  CColor m_color;
  CColor m_initColor;
  CObservableCone m_cone;
};

/** Put a directional LED into its cell, unless it is black. */
using CDirectionalLEDEntityGridUpdater = CCellGridUpdater<CDirectionalLEDEntity>;
using CDirectionalLEDEntitySpaceHashUpdater = CCellHashUpdater<CDirectionalLEDEntity>;

}  // namespace argos

#endif
