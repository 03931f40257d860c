#ifndef ARGOS3_PLUGINS_ENTITIES_TAG_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_TAG_ENTITY_H

#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/simulator/entities/cell_updaters.h>
#include <argos3/plugins/simulator/entities/medium_member.h>
#include <argos3/plugins/simulator/entities/observable.h>

#include <array>
#include <string>
#include <vector>

namespace argos {

class CTagMedium;

/**
 * A square with a text, like a printed bar code. It is in the xy plane of its frame, centred on the
 * origin, and readable within an angle around the z axis.
 *
 * Starts disabled. The medium contains it exactly while it is enabled.
 */
class CTagEntity : public CMediumMember<CTagEntity, CTagMedium> {
 public:
  ENABLE_VTABLE();

  typedef std::vector<CTagEntity*> TList;

  /** A tag of 10 cm without a text, readable from all sides. */
  explicit CTagEntity(CComposableEntity* parent);
  /**
   * @param position, orientation  m, world frame.
   * @param observableAngle        see SetObservableAngle().
   * @param sideLength             see SetSideLength().
   */
  CTagEntity(CComposableEntity* parent, const std::string& id, const CVector3& position,
             const CQuaternion& orientation, const CRadians& observableAngle, Real sideLength,
             const std::string& payload);
  ~CTagEntity() override;

  /** Reads `observable_angle`, `side_length`, `payload` (default empty), and the pose. */
  void Init(TConfigurationNode& tree) override;
  /** Restores the initial payload and pose. */
  void Reset() override;
  std::string GetTypeDescription() const override { return "tag"; }

  const std::string& GetPayload() const { return m_payload; }
  /** By code of its own robot: takes effect when all robots have been controlled (CRobotsCode). */
  void SetPayload(const std::string& payload) {
    if (CRobotsCode::MayRun() && CRobotsCode::ChangesLater(*this, "SetPayload()", [this, payload] {
          SetPayload(payload);
        })) {
      return;
    }
    m_payload = payload;
  }
  const std::string& GetInitPayload() const { return m_initPayload; }
  void SetInitPayload(const std::string& payload) { m_initPayload = payload; }

  /** Length of a side, m. */
  Real GetSideLength() const { return m_sideLength; }
  /** @param sideLength m, > 0. @throws CARGoSException if it is out of range. */
  void SetSideLength(Real sideLength);
  /**
   * The corners, m, world frame: first the one at (+,+) of the tag's frame, then counter-clockwise
   * as seen from the positive z axis.
   */
  std::array<CVector3, 4> ComputeCorners() const;

  const CRadians& GetObservableAngle() const { return m_cone.GetAngle(); }
  /**
   * @param angle  half angle of the readability cone around the z axis, in (0, PI].
   * @throws CARGoSException if the angle is out of range.
   */
  void SetObservableAngle(const CRadians& angle);
  /** @return true if a point (m, world frame) is in that cone. */
  bool Faces(const CVector3& point) const { return m_cone.Contains(*this, point); }

  void UpdateDigest(CDigest& digest) const override;

 private:
  CObservableCone m_cone;
  Real m_sideLength = 0.1;  // m
  std::string m_payload;
  std::string m_initPayload;
};

/** Put a tag into its cell. */
using CTagEntityGridUpdater = CCellGridUpdater<CTagEntity>;
using CTagEntitySpaceHashUpdater = CCellHashUpdater<CTagEntity>;

}  // namespace argos

#endif
