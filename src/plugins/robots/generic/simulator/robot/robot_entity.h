#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_ROBOT_ENTITY_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_ROBOT_ENTITY_H

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/visualization/appearance.h>
#include <argos3/plugins/robots/generic/simulator/device_parameters.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/proximity_sensor_equipped_entity.h>

#include <memory>
#include <string>
#include <vector>

namespace argos {

class CRobotEntity;

/** A component of a type of robots that one robot has only if somebody asks for it. */
struct SComponentOnDemand {
  const char* Type; /**< its GetTypeDescription() */
  /** Makes it, with MakeOnDemand(). */
  CEntity& (*Make)(CRobotEntity& robot);
};

/** What all robots of a type have in common. */
struct SRobotType {
  /** A frame besides "origin" that carries the LEDs, at the origin; empty: the origin does. */
  std::string LEDAnchor;
  std::shared_ptr<const CLEDEquippedEntity::SLayout> LEDs;
  std::shared_ptr<const CProximitySensorEquippedEntity::SLayout> Proximity;
  SAppearance Appearance;
  SDeviceParameters Parameters; /**< of a robot that gives none */
  std::vector<SComponentOnDemand> OnDemand;
};

/**
 * A robot: what the robots of this project have in common.
 *
 * Every robot has a body, LEDs, proximity sensors, and a controller. What else its type offers
 * ("rab", "light_sensors", ...) is made when a device, or a user, first asks for it, so that robots
 * pay only for the devices that they use. Making a component changes the space: it must not happen
 * while robots act or sense in parallel.
 */
class CRobotEntity : public CComposableEntity {
 public:
  /** Moves what hangs on the body, if it is in use, to where the body is. */
  void UpdateComponents() override;

  CControllableEntity& GetControllableEntity() { return *m_controllable; }
  const CControllableEntity& GetControllableEntity() const { return *m_controllable; }
  CEmbodiedEntity& GetEmbodiedEntity() { return *m_body; }
  const CEmbodiedEntity& GetEmbodiedEntity() const { return *m_body; }
  CLEDEquippedEntity& GetLEDEquippedEntity() { return *m_leds; }
  const CLEDEquippedEntity& GetLEDEquippedEntity() const { return *m_leds; }
  CProximitySensorEquippedEntity& GetProximitySensorEquippedEntity() { return *m_proximity; }
  const CProximitySensorEquippedEntity& GetProximitySensorEquippedEntity() const {
    return *m_proximity;
  }

  /** A robot that is enabled again uses the components on demand that it used before. */
  void SetEnabled(bool enabled) override;
  /** A component made on demand counts while it is in use: who only looks at it changes nothing. */
  void UpdateDigest(CDigest& digest) const override;

  const SAppearance* GetAppearance() const override { return &m_type.Appearance; }
  /** What this robot's devices are like. */
  const SDeviceParameters& GetDeviceParameters() const {
    return m_parameters != nullptr ? *m_parameters : m_type.Parameters;
  }

  /** Makes a component of this robot, which owns it; for SComponentOnDemand::Make. */
  template <typename COMPONENT, typename... ARGUMENTS>
  COMPONENT& MakeOnDemand(ARGUMENTS&&... arguments) {
    auto component = std::make_unique<COMPONENT>(this, std::forward<ARGUMENTS>(arguments)...);
    COMPONENT& borrowed = *component;
    // the controller's devices use components: it goes first when the robot is removed
    InsertComponent(*component.release(), *m_controllable);
    return borrowed;
  }

 protected:
  /**
   * Makes body, LEDs and proximity sensors; the derived class then makes what else all robots of
   * the type have, and calls AddController().
   * @param type                   must outlive the robot.
   * @param position, orientation  of the body, m, world frame.
   */
  CRobotEntity(const SRobotType& type, const std::string& id, const CVector3& position,
               const CQuaternion& orientation);

  /** Makes the component that holds the controller, the last one of the robot. */
  void AddController();
  /**
   * Reads `id` and `<body>`, and makes what `<directional_leds>`, `<tags>`, `<magnets>`,
   * `<simple_radios>` and `<rfid_tags>` mount on this robot. The controller's component must be
   * there already.
   */
  void InitParts(TConfigurationNode& tree);
  /** Before the controller is made. */
  void SetDeviceParameters(const SDeviceParameters& parameters);
  /** Makes the controller, with its devices, that `<controller>` asks for. */
  void InitController(TConfigurationNode& tree);
  /** Makes the controller of that id, if it is not empty. */
  void InitController(const std::string& controllerId);

  /** The component of SComponentOnDemand::Type @p type, made if it is not there yet. */
  template <typename COMPONENT>
  COMPONENT& Demand(const char* type) {
    return static_cast<COMPONENT&>(DemandComponent(type));
  }
  void MaterializeComponents(const std::string& type) override;
  void NoticeRemoval(const CEntity& component) override;
  void NoticeEnabling(const CEntity& component) override;

 private:
  CEntity& DemandComponent(const char* type);
  template <typename COMPONENT>
  void MountFromXML(TConfigurationNode& tree, const char* tag);
  void MakeComponent(size_t number);
  /** Tells the body whether a component has something to do after it has moved. */
  void CountFollowers();
  /** Number of a component in m_type.OnDemand, or their number if it is none of them. */
  size_t FindOnDemand(const CEntity& component) const;

  const SRobotType& m_type;
  std::unique_ptr<const SDeviceParameters> m_parameters;  // null: as usual for the type
  std::unique_ptr<CEntity*[]> m_onDemand;  // (m_type.OnDemand), null until made; not owned
  UInt32 m_inUse = 0;  // bit i: m_onDemand[i] was enabled when the robot was disabled
  std::unique_ptr<CEntity::TVector> m_mounted;  // from the file; null if nothing is; not owned
  // components
  CEmbodiedEntity* m_body = nullptr;
  CLEDEquippedEntity* m_leds = nullptr;
  CProximitySensorEquippedEntity* m_proximity = nullptr;
  CControllableEntity* m_controllable = nullptr;
};

}  // namespace argos

#endif
