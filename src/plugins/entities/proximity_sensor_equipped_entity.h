#ifndef ARGOS3_PLUGINS_ENTITIES_PROXIMITY_SENSOR_EQUIPPED_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_PROXIMITY_SENSOR_EQUIPPED_ENTITY_H

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/vector3.h>

#include <memory>
#include <vector>

namespace argos {

/**
 * The proximity sensors on a body: rays fixed in the frames of its anchors.
 *
 * Robots of a type share one layout. Starts disabled; the sensor that uses it enables it.
 */
class CProximitySensorEquippedEntity : public CEntity {
 public:
  ENABLE_VTABLE();

  /** One ray, for users; see GetSensors(). */
  struct SSensor {
    CVector3 Offset; /**< start of the ray in the anchor's frame, m */
    CVector3 Direction; /**< from start to end in the anchor's frame; as long as the range, m */
    SAnchor& Anchor;

    typedef std::vector<SSensor*> TList;

    /** @param direction of any length. @param range m. */
    SSensor(const CVector3& offset, const CVector3& direction, Real range, SAnchor& anchor);
  };

  /** The rays of a type of robot. */
  struct SRay {
    CVector3 Offset; /**< start in the anchor's frame, m */
    CVector3 Direction; /**< from start to end in the anchor's frame, m */
    UInt32 Anchor = 0; /**< which of the anchors given with the layout */
  };
  struct SLayout {
    std::vector<SRay> Rays;
    /** True if all rays are horizontal and on one anchor: what follows then holds. */
    bool Planar = true;
    /** A circle in the anchor's xy plane that holds all rays, m; written by AddSensor(). */
    Real CenterX = 0.0, CenterY = 0.0, Reach = 0.0;

    /** @throws CARGoSException if the direction is zero, or the range not > 0. */
    void AddSensor(const CVector3& offset, const CVector3& direction, Real range,
                   UInt32 anchor = 0);
    /** See CProximitySensorEquippedEntity::AddSensorFan(). */
    void AddSensorFan(const CVector3& center, Real radius, const CRadians& startAngle,
                      const CRadians& endAngle, Real range, UInt32 num, UInt32 anchor = 0);
    /** Recomputes all but the rays. */
    void ComputeBounds();
  };

  explicit CProximitySensorEquippedEntity(CComposableEntity* parent);
  CProximitySensorEquippedEntity(CComposableEntity* parent, const std::string& id);

  std::string GetTypeDescription() const override { return "proximity_sensors"; }
  /** Also of the anchors that carry sensors. */
  void SetEnabled(bool enabled) override;
  virtual void Enable() { CEntity::Enable(); }
  virtual void Disable() { CEntity::Disable(); }

  /** Takes over a layout. @param anchors  those that the layout numbers; of one body. */
  void SetLayout(std::shared_ptr<const SLayout> layout, const std::vector<SAnchor*>& anchors);
  /**
   * @param offset     start of the ray in the anchor's frame, m.
   * @param direction  in the anchor's frame, of any length but 0.
   * @param range      length of the ray, m, > 0.
   * @throws CARGoSException if the direction is zero, or the range not > 0.
   */
  void AddSensor(const CVector3& offset, const CVector3& direction, Real range, SAnchor& anchor);
  /**
   * Adds rays that start on a horizontal circle and point outward, counter-clockwise: ray i at
   * startAngle + i * 2 PI / num.
   */
  void AddSensorRing(const CVector3& center, Real radius, const CRadians& startAngle, Real range,
                     UInt32 num, SAnchor& anchor);
  /** The same on an arc: ray i at startAngle + i (endAngle - startAngle) / num. */
  void AddSensorFan(const CVector3& center, Real radius, const CRadians& startAngle,
                    const CRadians& endAngle, Real range, UInt32 num, SAnchor& anchor);

  size_t GetNumSensors() const { return m_layout->Rays.size(); }
  /** @throws CARGoSException if there is no sensor of that number. */
  SSensor& GetSensor(size_t index);
  /** Made when first asked for, owned by this entity; changes to its elements count. */
  SSensor::TList& GetSensors();

  /** The rays as they are now. */
  const SLayout& GetLayout() {
    if (m_sensors != nullptr) {
      TakeOverChanges();
    }
    return *m_layout;
  }
  /** @param number  SRay::Anchor. */
  const SAnchor& GetAnchor(UInt32 number) const { return *m_anchors[number]; }

 private:
  UInt32 NumberOfAnchor(SAnchor& anchor);
  void Append(SLayout&& layout);
  void TakeOverChanges();

  // the rays for users
  struct SSensors {
    std::vector<std::unique_ptr<SSensor>> Owned;  // (rays)
    SSensor::TList List;  // the same
  };

  // these two side by side: sensing looks at both for every robot in every tick. The layout is
  // shared by all robots of a type, and replaced, never changed, when sensors are added
  std::shared_ptr<const SLayout> m_layout;
  std::unique_ptr<SSensors> m_sensors;  // null until asked for
  std::vector<SAnchor*> m_anchors;  // those the layout numbers; not owned
};

}  // namespace argos

#endif
