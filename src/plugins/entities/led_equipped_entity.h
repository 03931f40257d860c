#ifndef ARGOS3_PLUGINS_ENTITIES_LED_EQUIPPED_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_LED_EQUIPPED_ENTITY_H

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/lazy_components.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/simulator/entities/anchor_use.h>
#include <argos3/plugins/simulator/entities/led_entity.h>

#include <memory>
#include <vector>

namespace argos {

/**
 * The LEDs on a body.
 *
 * LEDs become entities only when necessary (by a medium, GetLED(), GetLEDs(), or a component
 * look-up). Until then they are a colour each here and a place in a layout that all robots of a
 * type share. Materialize() creates the entities; it must not run while robots act or sense in
 * parallel.
 *
 * Starts disabled: the LEDs keep their colours and are invisible to cameras.
 */
class CLEDEquippedEntity : public CComposableEntity, private CLazyComponents {
 public:
  ENABLE_VTABLE();

  typedef std::vector<CColor, CSlabAllocator<CColor>> TLazyColors;

  /** An LED and its place. */
  struct SActuator {
    CLEDEntity& LED;
    CVector3 Offset; /**< offset in the anchor's frame, m */
    SAnchor& Anchor;

    typedef std::vector<SActuator*> TList;

    SActuator(CLEDEntity& led, const CVector3& offset, SAnchor& anchor)
        : LED(led), Offset(offset), Anchor(anchor) {}
  };

  /** Places of the LEDs, common to a type of robot. */
  struct SPlace {
    CVector3 Offset; /**< offset in the anchor's frame, m */
    UInt32 Anchor = 0; /**< index of the anchor in the layout */
    CColor Color; /**< colour at the start and after Reset() */
    bool IsSeenFromBeneath = false; /**< through the robot's own body, from below its base */
  };
  struct SLayout {
    std::vector<SPlace> Places;

    void AddLED(const CVector3& offset, const CColor& color = CColor(), UInt32 anchor = 0);
    /** See CLEDEquippedEntity::AddLEDRing(). */
    void AddLEDRing(const CVector3& center, Real radius, const CRadians& startAngle, UInt32 num,
                    const CColor& color = CColor(), UInt32 anchor = 0);
  };

  explicit CLEDEquippedEntity(CComposableEntity* parent);
  CLEDEquippedEntity(CComposableEntity* parent, const std::string& id);

  /**
   * Reads `medium` and the children `<led offset="x,y,z" anchor="..." color="..." />`, and enables
   * the LEDs. The parent must have a "body" with these anchors.
   * @throws CARGoSException with the known names if a medium or an anchor is unknown.
   */
  void Init(TConfigurationNode& tree) override;
  /** Restores the initial colours. */
  void Reset() override;
  std::string GetTypeDescription() const override { return "leds"; }
  /** Moves the LED entities to the current poses of their anchors. */
  void UpdateComponents() override;
  /** Also enables or disables the use of the anchors; enabled LEDs move to their anchors' poses. */
  void SetEnabled(bool enabled) override;
  virtual void Enable() { CComposableEntity::Enable(); }
  virtual void Disable() { CComposableEntity::Disable(); }

  /**
   * Sets the layout. @param anchors  the anchors that the layout refers to by index; of one body.
   */
  void SetLayout(std::shared_ptr<const SLayout> layout, const std::vector<SAnchor*>& anchors);
  /** @param offset in the anchor's frame, m. */
  void AddLED(const CVector3& offset, SAnchor& anchor, const CColor& color = CColor::BLACK);
  /**
   * Adds LEDs on a horizontal circle, counter-clockwise: LED i at startAngle + i * 2 PI / num.
   * @param center in the anchor's frame, m. @param radius m.
   */
  void AddLEDRing(const CVector3& center, Real radius, const CRadians& startAngle, UInt32 num,
                  SAnchor& anchor, const CColor& color = CColor::BLACK);

  size_t GetNumLEDs() const { return m_layout->Places.size(); }
  /** These throw CARGoSException if the index is out of range. */
  const CColor& GetLEDColor(size_t index) const;
  /** All colours while the LEDs are no entities, empty otherwise: for those who read all of them.
   */
  const TLazyColors& GetLazyColors() const { return m_colors; }
  CLEDEntity& GetLED(UInt32 index);
  /** One element per LED, owned by this entity. */
  SActuator::TList& GetLEDs();
  const CVector3& GetLEDOffset(size_t index) const;
  /** The anchor in whose frame the offset is. */
  const SAnchor& GetLEDAnchor(size_t index) const;
  void SetLEDOffset(UInt32 index, const CVector3& offset);
  void SetLEDColor(UInt32 index, const CColor& color);
  void SetAllLEDsColors(const CColor& color);
  /** @throws CARGoSException if the numbers of colours and of LEDs differ. */
  void SetAllLEDsColors(const std::vector<CColor>& colors);
  /** Adds all LEDs, including later ones, to a medium: a CLEDMedium. */
  void SetMedium(CLEDEntity::CRegistry& medium);

  /** Creates the LED entities unless they exist. */
  void Materialize();
  /** Number of LEDs that are not entities yet. */
  size_t GetNumLazyLEDs() const { return m_colors.size(); }

  /** Includes colours only: the same whether or not the LEDs are entities. */
  void UpdateDigest(CDigest& digest) const override;

 private:
  // CLazyComponents
  void Create(const std::string&) override { Materialize(); }
  void Forget(const CEntity&) override {}

  void CheckIndex(size_t index) const;
  void Append(SLayout&& layout);
  CLEDEntity& MakeLED(size_t index);
  void PlaceLED(SActuator& actuator) const;
  // the LEDs as entities
  struct SEntities {
    std::vector<std::unique_ptr<SActuator>> Owned;  // (LEDs)
    SActuator::TList List;  // the same, for users
  };

  // shared by all robots of a type; adding LEDs replaces it by a modified copy
  std::shared_ptr<const SLayout> m_layout;
  TAnchorsInUse m_anchors;  // referred to by the layout
  TLazyColors m_colors;  // (LEDs); empty if the LEDs are entities
  std::unique_ptr<SEntities> m_entities;  // null until needed
  CLEDEntity::CRegistry* m_medium = nullptr;
};

}  // namespace argos

#endif
