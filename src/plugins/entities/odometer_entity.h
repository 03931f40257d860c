#ifndef ARGOS3_PLUGINS_ENTITIES_ODOMETER_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_ODOMETER_ENTITY_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/simulator/physics_engine/planar_motion.h>
#include <argos3/plugins/simulator/entities/body_motion.h>
#include <argos3/plugins/simulator/entities/tick_watch.h>

#include <vector>

namespace argos {

class CWheeledEntity;

/**
 * Distances that the wheels of a robot roll, computed from the motion of the body instead of the
 * commanded speeds.
 *
 * A body that moves as its drive commands rolls its wheels as far as these turn. Where it deviates,
 * the deviation is assumed to happen at constant speeds along the heading, sideways, and about the
 * vertical, in the whole tick; sideways motion turns no wheel. So the distances are exact on the
 * arcs of a differential drive, for less than half a turn per tick. Moves by command turn no wheel.
 *
 * Where the wheels roll over the ground at other speeds than ordered (see CWheeledEntity), that
 * difference is subtracted: the distances are those that the motors turned. A wheel that is held
 * fast has none to subtract; one that rolls part of its way, in proportion.
 *
 * Starts disabled; the sensor that uses it enables it.
 */
class COdometerEntity : public CEntity {
 public:
  ENABLE_VTABLE();

  /** @throws CARGoSException unless the parent has "body" and "wheels". */
  COdometerEntity(CComposableEntity* parent, const std::string& id);

  void Reset() override;
  void Update() override;
  void SetEnabled(bool enabled) override;
  std::string GetTypeDescription() const override { return "odometer"; }

  /** Distance in the last tick, m, positive forward. @param wheel index of a wheel of "wheels". */
  Real GetRolledDistance(size_t wheel) const { return m_distances[wheel]; }

 private:
  void Measure();
  void SubtractDrift(Real lag);
  SDriveCommand ReadCommand() const;

  const CWheeledEntity* m_wheels;  // wheels of the parent
  CBodyMotion m_motion;  // motion since the end of the previous tick
  CTickWatch m_tick;
  SDriveCommand m_lastCommand;  // command of the previous tick
  std::vector<Real> m_distances;  // m, (wheels)
  // speeds in the previous tick, m/s, (wheels): over the ground, and ordered
  std::vector<Real> m_lastGround, m_lastOrdered;
};

}  // namespace argos

#endif
