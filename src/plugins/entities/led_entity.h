#ifndef ARGOS3_PLUGINS_ENTITIES_LED_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_LED_ENTITY_H

#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/simulator/space/positional_indices/grid.h>
#include <argos3/core/simulator/space/positional_indices/space_hash.h>
#include <argos3/core/utility/datatypes/color.h>
#include <argos3/core/utility/datatypes/set.h>

#include <vector>

namespace argos {

class CLEDMedium;

/**
 * A point of light. Cameras see it if it is enabled, has a medium, and is not black.
 *
 * Starts disabled. The medium knows it exactly while it is enabled.
 */
class CLEDEntity : public CPositionalEntity {
 public:
  ENABLE_VTABLE();

  typedef std::vector<CLEDEntity*> TList;
  typedef CSet<CLEDEntity*, SEntityComparator> TSet;

  /**
   * What knows the LEDs that can be seen: the side of CLEDMedium that LEDs need.
   *
   * Declared here, because the media library is built on this one.
   */
  class CRegistry {
   public:
    virtual void AddEntity(CLEDEntity& led) = 0;
    virtual void RemoveEntity(CLEDEntity& led) = 0;
    /** Itself. */
    virtual CLEDMedium& AsMedium() = 0;

   protected:
    ~CRegistry() = default;
  };

  explicit CLEDEntity(CComposableEntity* parent);
  /** @param position m, world frame. */
  CLEDEntity(CComposableEntity* parent, const std::string& id, const CVector3& position,
             const CColor& color);
  ~CLEDEntity() override;

  /** Reads `color`, and what CPositionalEntity::Init() reads. */
  void Init(TConfigurationNode& tree) override;
  /** Back to the initial colour and pose. */
  void Reset() override;
  /** Leaves the medium. */
  void Destroy() override;
  std::string GetTypeDescription() const override { return "led"; }
  void SetEnabled(bool enabled) override;

  const CColor& GetColor() const { return m_color; }
  /** False if it is black, and opaque: then no camera sees it. */
  bool IsLit() const { return m_color != CColor(); }
  const CColor& GetInitColor() const { return m_initColor; }
  virtual void SetColor(const CColor& color) { m_color = color; }
  void SetInitColor(const CColor& color) { m_initColor = color; }

  bool HasMedium() const { return m_medium != nullptr; }
  /** @throws CARGoSException if there is none. */
  CLEDMedium& GetMedium() const;
  /** Puts the LED in the care of @p medium, a CLEDMedium, and no other. */
  void SetMedium(CRegistry& medium);
  /** Takes the LED out of its medium, if it has one. */
  void ClearMedium();

  void UpdateDigest(CDigest& digest) const override;

 private:
  CColor m_color;
  CColor m_initColor;
  CRegistry* m_medium = nullptr;  // it forgets this LED, or this LED it, before either ends
};

/** Puts an LED into its cell of a grid, unless it is black. */
class CLEDEntityGridUpdater : public CGrid<CLEDEntity>::COperation {
 public:
  explicit CLEDEntityGridUpdater(CGrid<CLEDEntity>& grid) : m_grid(grid) {}
  bool operator()(CLEDEntity& led) override;

 private:
  CGrid<CLEDEntity>& m_grid;
};

/** Puts an LED into its cell of a space hash, unless it is black. */
class CLEDEntitySpaceHashUpdater : public CSpaceHashUpdater<CLEDEntity> {
 public:
  void operator()(CAbstractSpaceHash<CLEDEntity>& hash, CLEDEntity& led) override;
};

}  // namespace argos

#endif
