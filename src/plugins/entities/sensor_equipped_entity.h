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
 * Base of the components for proximity, light and ground sensors: sensors fixed in the frames of
 * the anchors of a body.
 *
 * Robots of a type share one layout. Starts disabled; the sensor that uses it enables it.
 *
 * @tparam LAYOUT  the sensors of a type of robot: GetPlaces() is a list of TPlace with a field
 *                 Anchor; ComputeBounds() updates the data derived from it.
 * @tparam SENSOR  one sensor, for users: constructed from a TPlace and its anchor; WriteTo(TPlace&)
 *                 updates the place and returns true if it changed.
 */
template <typename LAYOUT, typename SENSOR>
class CSensorEquippedEntity : public CEntity {
 public:
  typedef LAYOUT SLayout;
  typedef std::vector<SENSOR*> TSensors;

  explicit CSensorEquippedEntity(CComposableEntity* parent, const std::string& id = std::string())
      : CEntity(parent, id) {
    static const std::shared_ptr<const LAYOUT> kEmpty = std::make_shared<LAYOUT>();
    m_layout = kEmpty;
    CEntity::SetEnabled(false);
  }

  /** Also enables or disables the use of the anchors. */
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

  /**
   * Sets the layout. @param anchors  the anchors that the layout refers to by index; of one body.
   */
  void SetLayout(std::shared_ptr<const LAYOUT> layout, const std::vector<SAnchor*>& anchors) {
    ARGOS_ASSERT(GetNumSensors() == 0, "a layout would replace existing sensors");
    m_layout = std::move(layout);
    m_anchors.assign(anchors.begin(), anchors.end());
  }

  size_t GetNumSensors() const { return m_layout->GetPlaces().size(); }
  /** @throws CARGoSException if the index is out of range. */
  SENSOR& GetSensor(size_t index) {
    if (index >= GetNumSensors()) {
      THROW_ARGOSEXCEPTION(GetTypeDescription()
                           << " \"" << GetContext() << GetId() << "\": no sensor " << index
                           << "; there are " << GetNumSensors() << ", numbered from 0");
    }
    return *GetSensors()[index];
  }
  /** Created by the first call, owned by this entity; changes of the elements take effect. */
  TSensors& GetSensors() {
    if (m_sensors == nullptr) {
      m_sensors = std::make_unique<SSensors>();
    }
    for (size_t i = m_sensors->List.size(); i < GetNumSensors(); ++i) {
      const auto& place = m_layout->GetPlaces()[i];
      auto sensor = std::make_unique<SENSOR>(place, *m_anchors[place.Anchor]);
      m_sensors->Owned.push_back(std::move(sensor));
      m_sensors->List.push_back(m_sensors->Owned.back().get());
    }
    return m_sensors->List;
  }

  /** The current sensors. */
  const LAYOUT& GetLayout() {
    if (m_sensors != nullptr) {
      TakeOverChanges();
    }
    return *m_layout;
  }
  /** Where GetLayout() begins to read, to prefetch it. */
  const void* GetLayoutAddress() const { return &m_layout; }
  /** The anchors that the layout refers to by index. */
  const SAnchor* const* GetAnchors() const { return m_anchors.data(); }

 protected:
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
  // the sensors as seen by users
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

  // shared by all robots of a type; adding sensors replaces it by a modified copy
  std::shared_ptr<const LAYOUT> m_layout;
  std::unique_ptr<SSensors> m_sensors;  // null until the first request
  TAnchorsInUse m_anchors;  // referred to by the layout
};

}  // namespace argos

#endif
