#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_DISTANCE_SCANNER_EQUIPPED_ENTITY_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_DISTANCE_SCANNER_EQUIPPED_ENTITY_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/simulator/entities/tick_watch.h>

namespace argos {

/**
 * A distance scanner, as foot-bots have it: where it is on the body, and its rotation.
 *
 * Starts disabled, off, and at the angle 0. Devices enable it.
 */
class CFootBotDistanceScannerEquippedEntity : public CEntity {
 public:
  ENABLE_VTABLE();

  enum EMode : UInt8 { MODE_OFF, MODE_POSITION_CONTROL, MODE_SPEED_CONTROL };

  /** Where beams begin: on a circle around the vertical axis of the body. */
  struct SMount {
    Real Radius = 0.0; /**< m, of the body there */
    Real Elevation = 0.0; /**< m, above the base */
  };

  /** On a foot-bot. */
  explicit CFootBotDistanceScannerEquippedEntity(CComposableEntity* parent);
  CFootBotDistanceScannerEquippedEntity(CComposableEntity* parent, const std::string& id);

  const SMount& GetMount() const { return m_mount; }
  void SetMount(const SMount& mount) { m_mount = mount; }

  void Reset() override;
  /** Advances the rotation in speed control, once per tick. */
  void Update() override;
  void SetEnabled(bool enabled) override;
  std::string GetTypeDescription() const override { return "distance_scanner"; }

  EMode GetMode() const { return m_mode; }
  /** @throws CARGoSException if it is no EMode. */
  void SetMode(UInt8 mode);
  /** Angle of the first short-range head in the robot's frame, in [0, 2 PI). */
  const CRadians& GetRotation() const { return m_rotation; }
  /** Sets the angle at once. @throws CARGoSException if it is not finite. */
  void SetRotation(const CRadians& rotation);
  /** rad/s, positive counter-clockwise. */
  Real GetRotationSpeed() const { return m_speed; }
  /** For speed control. @throws CARGoSException if it is not finite. */
  void SetRotationSpeed(Real radiansPerSecond);
  /** The angle at the end of the tick before the last one, in [0, 2 PI). */
  const CRadians& GetPreviousRotation() const { return m_previous; }

  void UpdateDigest(CDigest& digest) const override;

 private:
  SMount m_mount;
  EMode m_mode = MODE_OFF;
  CRadians m_rotation;
  CRadians m_current;  // angle at the end of the last tick
  CRadians m_previous;  // angle at the end of the tick before
  Real m_speed = 0.0;  // rad/s
  CTickWatch m_tick;
};

}  // namespace argos

#endif
