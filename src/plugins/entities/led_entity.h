#ifndef ARGOS3_PLUGINS_ENTITIES_LED_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_LED_ENTITY_H

#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/utility/datatypes/color.h>
#include <argos3/core/utility/datatypes/set.h>
#include <argos3/plugins/simulator/entities/cell_updaters.h>
#include <argos3/plugins/simulator/entities/medium_member.h>

#include <vector>

namespace argos {

class CEmbodiedEntity;
class CLEDMedium;

/**
 * A point light. Cameras see it if it is enabled, has a medium, and is not black.
 *
 * Starts disabled. The medium contains it exactly while it is enabled.
 */
class CLEDEntity : public CMediumMember<CLEDEntity, CLEDMedium> {
 public:
  ENABLE_VTABLE();

  typedef std::vector<CLEDEntity*> TList;
  typedef CSet<CLEDEntity*, SEntityComparator> TSet;

  explicit CLEDEntity(CComposableEntity* parent);
  /** @param position m, world frame. */
  CLEDEntity(CComposableEntity* parent, const std::string& id, const CVector3& position,
             const CColor& color);
  ~CLEDEntity() override;

  /** Reads `color` and the attributes of CPositionalEntity::Init(). */
  void Init(TConfigurationNode& tree) override;
  /** Restores the initial colour and pose. */
  void Reset() override;
  std::string GetTypeDescription() const override { return "led"; }

  const CColor& GetColor() const { return m_color; }
  /** @return false if the colour is opaque black: such an LED is invisible to cameras. */
  bool IsLit() const { return m_color != CColor(); }
  /** Hides that of CMediumMember. */
  bool IsInCells() const { return IsLit(); }
  const CColor& GetInitColor() const { return m_initColor; }
  /** By code of its own robot: takes effect when all robots have been controlled (CRobotsCode). */
  virtual void SetColor(const CColor& color) {
    if (CRobotsCode::ChangesLater(*this, "SetColor()", [this, color] { SetColor(color); })) {
      return;
    }
    m_color = color;
  }
  void SetInitColor(const CColor& color) { m_initColor = color; }

  /**
   * The body that does not hide this LED from cameras below its base, because it is open there,
   * such as the arms of a flying robot; null if there is none.
   */
  const CEmbodiedEntity* GetBodyOpenBeneath() const { return m_bodyOpenBeneath; }
  void SetBodyOpenBeneath(const CEmbodiedEntity* body) {
    KeepForReset(m_bodyOpenBeneath);
    m_bodyOpenBeneath = body;
  }

  void UpdateDigest(CDigest& digest) const override;

 private:
  CColor m_color;
  CColor m_initColor;
  const CEmbodiedEntity* m_bodyOpenBeneath = nullptr;  // is not owned
};

/** Put an LED into its cell, unless it is black. */
using CLEDEntityGridUpdater = CCellGridUpdater<CLEDEntity>;
using CLEDEntitySpaceHashUpdater = CCellHashUpdater<CLEDEntity>;

}  // namespace argos

#endif
