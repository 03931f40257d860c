#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_ROBOT_ENTITY_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_ROBOT_ENTITY_H

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/lazy_components.h>
#include <argos3/core/simulator/visualization/appearance.h>
#include <argos3/plugins/robots/generic/simulator/device_parameters.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/proximity_sensor_equipped_entity.h>

#include <memory>
#include <string>
#include <vector>

namespace argos {

class CRobotEntity;

/** A component that a robot of a type has only after a device or a user has requested it. */
struct SComponentOnDemand {
  const char* Type; /**< GetTypeDescription() of the component */
  /** Creates the component with MakeOnDemand(). */
  CEntity& (*Make)(CRobotEntity& robot);
};

/** The properties that all robots of a type share. */
struct SRobotType {
  /** Anchor of the LEDs, added at the origin; empty: the LEDs are on the anchor "origin". */
  std::string LEDAnchor;
  std::shared_ptr<const CLEDEquippedEntity::SLayout> LEDs;
  std::shared_ptr<const CProximitySensorEquippedEntity::SLayout> Proximity;
  SAppearance Appearance;
  SDeviceParameters Parameters; /**< defaults */
  std::vector<SComponentOnDemand> OnDemand;
};

/**
 * Base of the robots of this project.
 *
 * Every robot has a body, LEDs, proximity sensors, and a controller. The other components of its
 * type ("rab", "light_sensors", ...) are created when a device or a user first requests them, so
 * that unused devices cost nothing. Creating a component changes the space: it must not happen
 * while robots act or sense in parallel.
 */
class CRobotEntity : public CComposableEntity, private CLazyComponents {
 public:
  /** Updates the enabled components that are attached to the body. */
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

  /** Re-enabling a robot restores which of its components on demand were enabled. */
  void SetEnabled(bool enabled) override;
  /**
   * Adds components on demand only while they are enabled: creating one by look-up does not change
   * the digest.
   */
  void UpdateDigest(CDigest& digest) const override;

  const SAppearance* GetAppearance() const override { return &m_type.Appearance; }
  /** Parameters of this robot's devices. */
  const SDeviceParameters& GetDeviceParameters() const {
    return m_parameters != nullptr ? *m_parameters : m_type.Parameters;
  }

  /** Creates a component, owned by this robot; for SComponentOnDemand::Make. */
  template <typename COMPONENT, typename... ARGUMENTS>
  COMPONENT& MakeOnDemand(ARGUMENTS&&... arguments) {
    auto component = std::make_unique<COMPONENT>(this, std::forward<ARGUMENTS>(arguments)...);
    COMPONENT& borrowed = *component;
    // the controller's devices use components: on removal the controller is removed first
    InsertComponent(*component.release(), *m_controllable);
    return borrowed;
  }

 protected:
  /**
   * Creates body, LEDs and proximity sensors; the derived class then creates further components
   * that all robots of the type have, and calls AddController().
   * @param type                   must outlive the robot.
   * @param position, orientation  of the body, m, world frame.
   */
  CRobotEntity(const SRobotType& type, const std::string& id, const CVector3& position,
               const CQuaternion& orientation);

  /** Creates the component for the controller, the last component of the robot. */
  void AddController();
  /**
   * Reads `id` and `<body>`, and creates the components for `<directional_leds>`, `<tags>`,
   * `<magnets>`, `<simple_radios>` and `<rfid_tags>`. The controller's component must exist.
   */
  void InitParts(TConfigurationNode& tree);
  /** To be called before the controller is created. */
  void SetDeviceParameters(const SDeviceParameters& parameters);
  /** Creates the controller that `<controller>` names, with its devices. */
  void InitController(TConfigurationNode& tree);
  /** Creates the controller of that id, unless the id is empty. */
  void InitController(const std::string& controllerId);

  /** @return the component of SComponentOnDemand::Type @p type, created on the first call. */
  template <typename COMPONENT>
  COMPONENT& GetOrCreate(const char* type) {
    return static_cast<COMPONENT&>(GetOrCreateComponent(type));
  }

 private:
  // CLazyComponents
  void Create(const std::string& type) override;
  void Forget(const CEntity& component) override;

  CEntity& GetOrCreateComponent(const char* type);
  template <typename COMPONENT>
  void MountFromXML(TConfigurationNode& tree, const char* tag);
  void MakeComponent(size_t number);
  /** @return index of a component in m_type.OnDemand; its size if it is not one of them. */
  size_t FindOnDemand(const CEntity& component) const;

  const SRobotType& m_type;
  std::unique_ptr<const SDeviceParameters> m_parameters;  // null: the defaults of the type
  std::unique_ptr<CEntity*[]> m_onDemand;  // (m_type.OnDemand), null until created; not owned
  UInt32 m_inUse = 0;  // bit i: m_onDemand[i] was enabled when the robot was disabled
  std::unique_ptr<CEntity::TVector> m_mounted;  // created by InitParts(); null if empty; not owned
  // components
  CEmbodiedEntity* m_body = nullptr;
  CLEDEquippedEntity* m_leds = nullptr;
  CProximitySensorEquippedEntity* m_proximity = nullptr;
  CControllableEntity* m_controllable = nullptr;
};

}  // namespace argos

#endif
