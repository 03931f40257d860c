#ifndef ARGOS3_CORE_SIMULATOR_ENTITY_CONTROLLABLE_ENTITY_H
#define ARGOS3_CORE_SIMULATOR_ENTITY_CONTROLLABLE_ENTITY_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/control_interface/on_error.h>
#include <argos3/core/simulator/entity/actuator.h>
#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/simulator/entity/sensor.h>
#include <argos3/core/utility/math/ray3.h>
#include <argos3/core/utility/math/rng_owner.h>
#include <argos3/core/utility/memory/object_slabs.h>

#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace argos {

class CLoadErrors;
class CSignalSafeText;
class CSimulator;
class CSpace;
struct SControllerSetup;
struct SSimulationContext;

/**
 * What makes an entity a robot: its controller, and the sensors and actuators the controller uses.
 *
 * Act(), Sense() and ControlStep() of different robots run at the same time on several threads;
 * each touches only its own robot.
 */
class CControllableEntity : public CEntity {
 public:
  ENABLE_VTABLE();

  typedef std::vector<CControllableEntity*> TVector;
  typedef std::map<std::string, CControllableEntity*> TMap;

  explicit CControllableEntity(CComposableEntity* parent);
  CControllableEntity(CComposableEntity* parent, const std::string& id);
  ~CControllableEntity() override;

  /** Reads `config` (a controller's id) and the optional `<params>` that replace its own. */
  void Init(TConfigurationNode& tree) override;
  void Reset() override;
  void Destroy() override;
  std::string GetTypeDescription() const override { return "controller"; }
  void UpdateDigest(CDigest& digest) const override;
  /** Also notes which of the controller's sensors are enabled. */
  void MarkStart() override;
  void ReturnToStart() override;

  /** False for a robot of a replay, and while a controller is created. */
  bool HasController() const { return m_pcController != nullptr; }
  /** How many controllers the robot has had: what refers to one, or to its devices, is then old. */
  UInt32 GetNumControllers() const { return m_numControllers; }
  /** @throws CARGoSException if the robot has no controller. */
  const CCI_Controller& GetController() const;
  CCI_Controller& GetController();
  /**
   * Creates the controller with its devices, actuators first, and runs its Init(). The
   * previous controller is destroyed first. In a run, Reset() keeps the new one; the components
   * and devices that are enabled now are then also those enabled at the start.
   *
   * While robots act, sense or are controlled, a robot that is not in the space yet gets its
   * controller when it is added, at the end of the tick.
   * @param controllerId  `id` of a child of `<controllers>`.
   * @throws CARGoSException if the id, a device, or an implementation is unknown, with what exists;
   *   if robots act, sense or are controlled and this robot is in the space.
   */
  void SetController(const std::string& controllerId);
  void SetController(const std::string& controllerId, TConfigurationNode& params);

  /** Creates the controller that SetController() has left for later, if there is one. */
  void SetLateController();

  /** Updates the enabled sensors, in alphabetical order of their XML tags. */
  virtual void Sense();
  virtual void ControlStep();
  /** Applies the actuators, in alphabetical order of their XML tags. */
  virtual void Act();

  /** What follows when the code of this robot throws in a run. */
  EOnError GetOnError() const { return m_onError; }
  /**
   * Notes an error that does not end the run. The controller is not called any more, nor are the
   * devices if one of them has failed; Reset() undoes this.
   * @param byDevice  a sensor or an actuator threw.
   * @param context, cause  see CRobotFailures::Note().
   */
  void Stop(bool byDevice, const std::string& context, const std::string& cause);
  /** True after an error that did not end the run, until Reset(). */
  bool IsStopped() const { return m_isStopped; }
  /** For replays, whose robots have no controller. */
  void SetStopped(bool stopped) { m_isStopped = stopped; }
  /** True if the robot was also removed from physics and media (CSpace::Quarantine()). */
  bool IsQuarantined() const { return m_isQuarantined; }
  void SetQuarantined(bool quarantined) { m_isQuarantined = quarantined; }

  /** Appends, as in: robot "ep", controller "c" (<lua_controller>). For signal handlers, too. */
  static void Describe(const void* robot, CSignalSafeText& text);

  /** Records a ray that a sensor cast, to be drawn. Cleared at each Sense(). */
  void AddCheckedRay(bool obstructed, const CRay3& ray);
  /** Records the point at fraction @p tOnRay of @p ray. */
  void AddIntersectionPoint(const CRay3& ray, Real tOnRay);
  std::vector<std::pair<bool, CRay3>>& GetCheckedRays() { return m_vecCheckedRays; }
  std::vector<CVector3>& GetIntersectionPoints() { return m_vecIntersectionPoints; }

  /** The space that contains this robot, for its devices. */
  CSpace& GetSpace() const;
  /** The simulator this robot belongs to, for its devices. */
  CSimulator& GetSimulator() const;

  /** Of the generators that the controller and its devices create, which end with them. */
  CRandom::COwner& GetRandomOwner() { return m_randomOwner; }

  /** The devices by XML tag; the maps are created at the first call. */
  const std::map<std::string, CSimulatedActuator*>& GetActuators() const;
  const std::map<std::string, CSimulatedSensor*>& GetSensors() const;

  // Prefetch what loops over robots read (CLookAhead, recordings): the entity, flags and rays
  // included; then what functions reach through it, which LoadEntityAhead() has prefetched before.
  void LoadEntityAhead() const;
  void LoadActuatorListAhead() const { LoadAhead(m_actuators.data(), 1); }
  void LoadActuatorsAhead() const;
  void LoadSensorsAhead() const;
  void LoadControllerAhead() const;
  /** Appends CSimulatedSensor::ListMemory() of the sensors. */
  void ListMemory(std::vector<SMemory>& memory) const;

 protected:
  CCI_Controller* m_pcController = nullptr;  // owned through m_controller

 private:
  struct SSensorEntry {
    CSimulatedSensor* Simulated;
    CCI_Sensor* Interface;  // the same object
  };

  // arguments of SetController() while robots were updated
  struct SLateController {
    std::string Id;
    TConfigurationNode* Params;  // null: those of the controller's element
  };

  template <typename CALL>
  void CallUser(const char* call, CALL&& function);
  std::string DescribeForErrors() const;
  void CreateController(const SControllerSetup& setup, TConfigurationNode& params);
  UInt64 GetBirth() const;
  void CreateActuators(TConfigurationNode& controllerNode, CLoadErrors& errors);
  void CreateSensors(TConfigurationNode& controllerNode, CLoadErrors& errors);
  void ListDevices();
  void DropController();

  // What the tick reads is together, from m_pcController to the points below.
  // the devices in alphabetical order; filled once after creation
  std::vector<CSimulatedActuator*, CSlabAllocator<CSimulatedActuator*>> m_actuators;
  std::vector<SSensorEntry, CSlabAllocator<SSensorEntry>> m_sensors;
  EOnError m_onError = EOnError::EndRun;
  bool m_isStopped = false;
  bool m_haveDevicesFailed = false;
  bool m_isQuarantined = false;

 protected:
  std::vector<std::pair<bool, CRay3>> m_vecCheckedRays;
  std::vector<CVector3> m_vecIntersectionPoints;
  // filled by GetActuators() and GetSensors(); the controller owns the devices
  mutable std::map<std::string, CSimulatedActuator*> m_mapActuators;
  mutable std::map<std::string, CSimulatedSensor*> m_mapSensors;

 private:
  SSimulationContext& m_context;
  CRandom::COwner m_randomOwner;  // outlives the controller
  std::unique_ptr<CCI_Controller> m_controller;
  const SControllerSetup* m_setup = nullptr;  // setup of the controller
  std::unique_ptr<SLateController> m_lateController;
  UInt32 m_numControllers = 0;
};

}  // namespace argos

#endif
