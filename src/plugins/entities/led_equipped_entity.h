#ifndef ARGOS3_PLUGINS_ENTITIES_LED_EQUIPPED_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_LED_EQUIPPED_ENTITY_H

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/lazy_components.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/simulator/entities/led_entity.h>

#include <memory>
#include <vector>

namespace argos {

/**
 * The LEDs on a body.
 *
 * Until someone needs them as entities (a medium, GetLED(), GetLEDs(), a component look-up), LEDs
 * are only a colour each here, and a place in a layout that all robots of a type share.
 * Materialize() makes the entities; it must not run while robots act or sense in parallel.
 *
 * Starts disabled: then cameras see none of the LEDs, which keep their colours.
 */
class CLEDEquippedEntity : public CComposableEntity, private CLazyComponents {
 public:
  ENABLE_VTABLE();

  /** An LED and where it sits. */
  struct SActuator {
    CLEDEntity& LED;
    CVector3 Offset; /**< in the anchor's frame, m */
    SAnchor& Anchor;

    typedef std::vector<SActuator*> TList;

    SActuator(CLEDEntity& led, const CVector3& offset, SAnchor& anchor)
        : LED(led), Offset(offset), Anchor(anchor) {}
  };

  /** Where the LEDs of a type of robot sit. */
  struct SPlace {
    CVector3 Offset; /**< in the anchor's frame, m */
    UInt32 Anchor = 0; /**< which of the anchors given with the layout */
    CColor Color; /**< at the start and after Reset() */
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
   * the LEDs. The parent must have a "body" with the anchors named.
   * @throws CARGoSException with the known names if a medium or an anchor is unknown.
   */
  void Init(TConfigurationNode& tree) override;
  /** All LEDs get their initial colours back. */
  void Reset() override;
  std::string GetTypeDescription() const override { return "leds"; }
  /** Puts the LED entities where their anchors are now. */
  void UpdateComponents() override;
  /** Also of the anchors that carry LEDs; LEDs that are enabled go where their anchors are. */
  void SetEnabled(bool enabled) override;
  virtual void Enable() { CComposableEntity::Enable(); }
  virtual void Disable() { CComposableEntity::Disable(); }

  /** Takes over a layout. @param anchors  those that the layout numbers; of one body. */
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
  /** What follows throws CARGoSException if there is no LED of that number. */
  const CColor& GetLEDColor(size_t index) const;
  CLEDEntity& GetLED(UInt32 index);
  /** One for each LED, owned by this entity. */
  SActuator::TList& GetLEDs();
  const CVector3& GetLEDOffset(size_t index) const;
  void SetLEDOffset(UInt32 index, const CVector3& offset);
  void SetLEDColor(UInt32 index, const CColor& color);
  void SetAllLEDsColors(const CColor& color);
  /** @throws CARGoSException if the numbers of colours and of LEDs differ. */
  void SetAllLEDsColors(const std::vector<CColor>& colors);
  /** Gives all LEDs, also those added later, to a medium: a CLEDMedium. */
  void SetMedium(CLEDEntity::CRegistry& medium);

  /** Creates the LED entities if they do not exist yet. */
  void Materialize();
  /** Number of LEDs that are not entities yet. */
  size_t GetNumLazyLEDs() const { return m_colors.size(); }

  /** Colours only: the same whether or not the LEDs are entities. */
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

  // shared by all robots of a type, and replaced, never changed, when LEDs are added
  std::shared_ptr<const SLayout> m_layout;
  std::vector<SAnchor*> m_anchors;  // those the layout numbers; not owned
  std::vector<CColor> m_colors;  // (LEDs); empty if they are entities, which then hold them
  std::unique_ptr<SEntities> m_entities;  // null until someone needs them
  CLEDEntity::CRegistry* m_medium = nullptr;
};

}  // namespace argos

#endif
