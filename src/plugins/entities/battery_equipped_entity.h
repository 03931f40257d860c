#ifndef ARGOS3_PLUGINS_ENTITIES_BATTERY_EQUIPPED_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_BATTERY_EQUIPPED_ENTITY_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/utility/configuration/base_configurable_resource.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/plugins/factory.h>
#include <argos3/plugins/simulator/entities/body_motion.h>
#include <argos3/plugins/simulator/entities/tick_watch.h>

#include <memory>
#include <string>

namespace argos {

class CBatteryEquippedEntity;

/**
 * Discharge model of a battery. Users derive from this class and register theirs with
 * REGISTER_BATTERY_DISCHARGE_MODEL() under the label that `<battery discharge_model="..." />`
 * gives.
 */
class CBatteryDischargeModel : public CBaseConfigurableResource {
 public:
  /** Reads the model's attributes of the `<battery>` element, all optional. */
  void Init(TConfigurationNode& /*battery*/) override {}
  void Reset() override {}
  void Destroy() override {}

  /** Called once; the battery outlives the model. */
  virtual void SetBattery(CBatteryEquippedEntity* battery) { m_pcBattery = battery; }
  /** Reduces the battery's charge. Called once a tick, after the robot has moved. */
  virtual void operator()() = 0;

 protected:
  CBatteryEquippedEntity* m_pcBattery = nullptr;  // is not owned
};

/**
 * The battery of a robot. It only counts charge: an empty battery does not stop the robot.
 *
 * Starts disabled and is discharged only while enabled; the sensor that reads it enables it.
 */
class CBatteryEquippedEntity : public CEntity {
 public:
  ENABLE_VTABLE();

  explicit CBatteryEquippedEntity(CComposableEntity* parent);
  /**
   * @param parent       has a "body", for models that need one.
   * @param model        owned from now on; null: the charge never falls.
   * @param startCharge  charge at the start and after a reset, in [0, fullCharge].
   * @param fullCharge   > 0.
   * @throws CARGoSException if a charge is out of range.
   */
  CBatteryEquippedEntity(CComposableEntity* parent, const std::string& id,
                         CBatteryDischargeModel* model = nullptr, Real startCharge = 1.0,
                         Real fullCharge = 1.0);
  /**
   * @param model  label of a model; empty: the charge never falls. @throws CARGoSException as
   *   above, and if the label is unknown.
   */
  CBatteryEquippedEntity(CComposableEntity* parent, const std::string& id, const std::string& model,
                         Real startCharge = 1.0, Real fullCharge = 1.0);
  ~CBatteryEquippedEntity() override;

  /** Reads `id` and the attributes of Configure(). */
  void Init(TConfigurationNode& tree) override;
  /**
   * Reads `discharge_model` ("time"), `start_charge` (1), `full_charge` (1), and the model's
   * attributes.
   * @throws CARGoSException if the model is unknown or a value is out of range.
   */
  void Configure(TConfigurationNode& battery);
  /** Restores the start charge. */
  void Reset() override;
  /** Applies the discharge model, once a tick. */
  void Update() override;
  void SetEnabled(bool enabled) override;
  std::string GetTypeDescription() const override { return "battery"; }

  Real GetFullCharge() const { return m_fullCharge; }
  /** @throws CARGoSException if the charge is not > 0. */
  void SetFullCharge(Real charge);
  Real GetAvailableCharge() const { return m_availableCharge; }
  /** @throws CARGoSException if the charge is not >= 0. */
  void SetAvailableCharge(Real charge);
  /** Reduces the charge by @p amount, to 0 at least. */
  void Discharge(Real amount);
  /** Takes ownership of the model; null: the charge never falls. */
  void SetDischargeModel(CBatteryDischargeModel* model);
  /** @param label  empty: the charge never falls. @throws CARGoSException if it is unknown. */
  void SetDischargeModel(const std::string& label);

  /**
   * Motion of the body's origin in this tick, for models: m, and rad in [0, PI] about any axis.
   * Excludes moves by command.
   * @throws CARGoSException if the robot has no body.
   */
  Real ComputeDistanceMoved() const;
  CRadians ComputeAngleTurned() const;

  void UpdateDigest(CDigest& digest) const override;

 private:
  void ReplaceModel(std::unique_ptr<CBatteryDischargeModel> model);
  void RequireBody() const;

  std::unique_ptr<CBatteryDischargeModel> m_model;
  Real m_startCharge = 1.0;
  Real m_fullCharge = 1.0;
  Real m_availableCharge = 1.0;
  CTickWatch m_tick;
  CBodyMotion m_motion;  // motion since the end of the previous tick
};

}  // namespace argos

#define REGISTER_BATTERY_DISCHARGE_MODEL(CLASSNAME, LABEL)                                         \
  REGISTER_SYMBOL(CBatteryDischargeModel, CLASSNAME, LABEL, "undefined", "undefined", "undefined", \
                  "undefined", "undefined")

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/plugins/simulator/entities/battery_discharge_models.h>
#endif

#endif
