#ifndef ARGOS3_PLUGINS_ENTITIES_ODOMETER_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_ODOMETER_ENTITY_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/plugins/simulator/entities/body_motion.h>
#include <argos3/plugins/simulator/entities/tick_watch.h>

#include <vector>

namespace argos {

class CWheeledEntity;

/**
 * How far the wheels of a robot roll: as the body really moves, whatever its controller ordered.
 *
 * In each tick the body is taken to move with constant speed along its heading, sideways, and about
 * the vertical; what it slides sideways turns no wheel. That is exact on the arcs of a differential
 * drive, for less than half a turn a tick. Moves by command turn no wheel either.
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

  /** In the last tick, m, positive ahead. @param wheel number of a wheel of "wheels". */
  Real GetRolledDistance(size_t wheel) const { return m_distances[wheel]; }

 private:
  void Measure();

  const CWheeledEntity* m_wheels;  // of the parent
  CBodyMotion m_motion;  // since the end of the previous tick
  CTickWatch m_tick;
  std::vector<Real> m_distances;  // m, (wheels)
};

}  // namespace argos

#endif
