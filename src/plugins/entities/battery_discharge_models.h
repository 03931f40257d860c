#ifndef ARGOS3_PLUGINS_ENTITIES_BATTERY_DISCHARGE_MODELS_H
#define ARGOS3_PLUGINS_ENTITIES_BATTERY_DISCHARGE_MODELS_H

#include <argos3/plugins/simulator/entities/battery_equipped_entity.h>

namespace argos {

/** "time": a constant charge per tick. */
class CBatteryDischargeModelTime : public CBatteryDischargeModel {
 public:
  /** Reads `delta`, charge per tick, default 1e-5. @throws CARGoSException if it is < 0. */
  void Init(TConfigurationNode& battery) override;
  void operator()() override;

  Real GetDelta() const { return m_delta; }
  /** @param delta  charge per tick, >= 0. @throws CARGoSException if it is out of range. */
  void SetDelta(Real delta);

 private:
  Real m_delta = 1e-5;
};

/** "motion": a constant charge per metre moved and per radian turned. */
class CBatteryDischargeModelMotion : public CBatteryDischargeModel {
 public:
  /**
   * Reads `pos_delta`, charge per m, and `orient_delta`, charge per rad, default 1e-3 each.
   * @throws CARGoSException if a value is < 0.
   */
  void Init(TConfigurationNode& battery) override;
  void operator()() override;

  /** Charge per m and per rad. */
  Real GetPosFactor() const { return m_positionDelta; }
  Real GetOrientFactor() const { return m_orientationDelta; }
  /** These throw CARGoSException if the factor is not >= 0. */
  void SetPosFactor(Real factor);
  void SetOrientFactor(Real factor);

 private:
  Real m_positionDelta = 1e-3;
  Real m_orientationDelta = 1e-3;
};

/** "time_motion": the sum of both models. */
class CBatteryDischargeModelTimeMotion : public CBatteryDischargeModel {
 public:
  /**
   * Reads `time_factor`, charge per tick, default 1e-5, and `pos_factor`, charge per m, and
   * `orient_factor`, charge per rad, default 1e-3 each.
   * @throws CARGoSException if a value is < 0.
   */
  void Init(TConfigurationNode& battery) override;
  void operator()() override;

  /** Charge per tick, per m and per rad. */
  Real GetDelta() const { return m_timeFactor; }
  Real GetPosFactor() const { return m_positionFactor; }
  Real GetOrientFactor() const { return m_orientationFactor; }
  /** These throw CARGoSException if the value is not >= 0. */
  void SetDelta(Real delta);
  void SetPosFactor(Real factor);
  void SetOrientFactor(Real factor);

 private:
  Real m_timeFactor = 1e-5;
  Real m_positionFactor = 1e-3;
  Real m_orientationFactor = 1e-3;
};

}  // namespace argos

#endif
