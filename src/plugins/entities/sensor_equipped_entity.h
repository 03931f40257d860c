#ifndef ARGOS3_PLUGINS_ENTITIES_SENSOR_EQUIPPED_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_SENSOR_EQUIPPED_ENTITY_H

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/entity.h>
#include <argos3/plugins/simulator/entities/anchor_use.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace argos {

/**
 * Sensors fixed in the frames of the anchors of a body: what the components for proximity, light
 * and ground sensors have in common.
 *
 * Robots of a type share one layout. Starts disabled; the sensor that uses it enables it.
 *
 * @tparam LAYOUT  the sensors of a type of robot: a list GetPlaces() of TPlace, which has a number
 *                 Anchor; ComputeBounds() recomputes what is derived from them.
 * @tparam SENSOR  one sensor, for users: made from a TPlace and its anchor; WriteTo(TPlace&) tells
 *                 whether it changed the place.
 */
template <typename LAYOUT, typename SENSOR>
class CSensorEquippedEntity : public CEntity {
 public:
  typedef LAYOUT SLayout;
  typedef std::vector<SENSOR*> TSensors;

  /** Also of the anchors that carry sensors. */
  void SetEnabled(bool enabled) override {
    if (enabled == IsEnabled()) {
      return;
    }
    CEntity::SetEnabled(enabled);
    for (SAnchor* anchor : m_anchors) {
      UseAnchor(*anchor, enabled);
    }
  }
  virtual void Enable() { CEntity::Enable(); }
  virtual void Disable() { CEntity::Disable(); }

  /** Takes over a layout. @param anchors  those that the layout numbers; of one body. */
  void SetLayout(std::shared_ptr<const LAYOUT> layout, const std::vector<SAnchor*>& anchors) {
    ARGOS_ASSERT(GetNumSensors() == 0, "a layout replaces sensors that exist already");
    m_layout = std::move(layout);
    m_anchors.assign(anchors.begin(), anchors.end());
  }

  size_t GetNumSensors() const { return m_layout->GetPlaces().size(); }
  /** @throws CARGoSException if there is no sensor of that number. */
  SENSOR& GetSensor(size_t index) {
    if (index >= GetNumSensors()) {
      THROW_ARGOSEXCEPTION(GetTypeDescription()
                           << " \"" << GetContext() << GetId() << "\": no sensor " << index
                           << "; there are " << GetNumSensors() << ", numbered from 0");
    }
    return *GetSensors()[index];
  }
  /** Made when first asked for, owned by this entity; changes to its elements count. */
  TSensors& GetSensors() {
    if (m_sensors == nullptr) {
      m_sensors = std::make_unique<SSensors>();
    }
    for (size_t i = m_sensors->List.size(); i < GetNumSensors(); ++i) {
      const auto& place = m_layout->GetPlaces()[i];
      auto sensor = std::make_unique<SENSOR>(place, *m_anchors[place.Anchor]);
      m_sensors->List.push_back(sensor.get());
      m_sensors->Owned.push_back(std::move(sensor));
    }
    return m_sensors->List;
  }

  /** The sensors as they are now. */
  const LAYOUT& GetLayout() {
    if (m_sensors != nullptr) {
      TakeOverChanges();
    }
    return *m_layout;
  }
  /** Those that the layout numbers. */
  const SAnchor* const* GetAnchors() const { return m_anchors.data(); }

 protected:
  CSensorEquippedEntity(CComposableEntity* parent, const std::string& id) : CEntity(parent, id) {
    static const std::shared_ptr<const LAYOUT> kEmpty = std::make_shared<LAYOUT>();
    m_layout = kEmpty;
    CEntity::SetEnabled(false);
  }

  /** Replaces the layout: change(LAYOUT&, UInt32 numberOfAnchor) adds sensors on @p anchor. */
  template <typename CHANGE>
  void Append(SAnchor& anchor, CHANGE&& change) {
    LAYOUT layout = GetLayout();
    change(layout, NumberOfAnchor(m_anchors, anchor, *this));
    const bool listed = m_sensors != nullptr;
    m_layout = std::make_shared<const LAYOUT>(std::move(layout));
    if (listed) {
      GetSensors();
    }
  }

 private:
  // the sensors for users
  struct SSensors {
    std::vector<std::unique_ptr<SENSOR>> Owned;  // (places)
    TSensors List;  // the same
  };

  void TakeOverChanges() {
    std::shared_ptr<LAYOUT> changed;
    for (size_t i = 0; i < m_sensors->List.size(); ++i) {
      typename LAYOUT::TPlace place = m_layout->GetPlaces()[i];
      if (!m_sensors->List[i]->WriteTo(place)) {
        continue;
      }
      if (changed == nullptr) {
        changed = std::make_shared<LAYOUT>(*m_layout);
      }
      changed->GetPlaces()[i] = place;
    }
    if (changed != nullptr) {
      changed->ComputeBounds();
      m_layout = std::move(changed);
    }
  }

  // shared by all robots of a type, and replaced, never changed, when sensors are added
  std::shared_ptr<const LAYOUT> m_layout;
  std::unique_ptr<SSensors> m_sensors;  // null until asked for
  std::vector<SAnchor*> m_anchors;  // those the layout numbers; not owned
};

}  // namespace argos

#endif
