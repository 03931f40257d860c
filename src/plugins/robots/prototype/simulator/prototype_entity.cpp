#include <argos3/plugins/robots/prototype/simulator/prototype_entity.h>

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/core/simulator/visualization/solid_part.h>
#include <argos3/core/utility/configuration/single_element.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/plugins/robots/generic/simulator/described_parts.h>
#include <argos3/plugins/robots/prototype/simulator/prototype_assembly.h>
#include <argos3/plugins/simulator/entities/directional_led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/joint_equipped_entity.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/magnet_equipped_entity.h>
#include <argos3/plugins/simulator/entities/new_component.h>
#include <argos3/plugins/simulator/entities/proximity_sensor_equipped_entity.h>
#include <argos3/plugins/simulator/entities/rfid_tag_equipped_entity.h>
#include <argos3/plugins/simulator/entities/simple_radio_equipped_entity.h>
#include <argos3/plugins/simulator/entities/tag_equipped_entity.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <array>

namespace argos {

namespace {

// sizes that only views use
constexpr Real kLEDDiameter = 0.008;  // m
constexpr std::array<CColor, 4> kLinkColors = {CColor(96, 108, 122), CColor(201, 142, 64),
                                               CColor(92, 145, 118), CColor(140, 110, 160)};

}  // namespace

CPrototypeEntity::CPrototypeEntity() : CComposableEntity(nullptr) {
  m_body = NewComponent<CEmbodiedEntity>(*this, "body_0");
}

void CPrototypeEntity::Init(TConfigurationNode& tree) {
  CComposableEntity::Init(tree);
  InitBody(tree);
  if (NodeExists(tree, "devices")) {
    InitDevices(GetNode(tree, "devices"));
  }
  if (NodeExists(tree, "controller")) {
    m_controllable = NewComponent<CControllableEntity>(*this, "controller_0");
    m_controllable->Init(GetNode(tree, "controller"));
  }
}

CJointEquippedEntity& CPrototypeEntity::GetJointEquippedEntity() {
  if (m_joints == nullptr) {
    THROW_ARGOSEXCEPTION("prototype \"" << GetId() << "\" has no joint that moves");
  }
  return *m_joints;
}

CControllableEntity& CPrototypeEntity::GetControllableEntity() {
  if (m_controllable == nullptr) {
    THROW_ARGOSEXCEPTION("prototype \"" << GetId() << "\" has no controller");
  }
  return *m_controllable;
}

void CPrototypeEntity::InitBody(TConfigurationNode& tree) {
  bool movable = true;
  GetNodeAttributeOrDefault(tree, "movable", movable, movable);
  const SPrototypeAssembly assembly = AssemblePrototype(tree, movable);
  const auto& articulation = assembly.Body->Articulation;
  m_body->Init(GetNode(tree, "body"));
  m_body->SetBodyDescription(assembly.Body);
  // the base of an articulated body may be fixed, but its other links move
  m_body->SetMovable(movable || articulation != nullptr);
  for (const SPlacedLink& link : assembly.Links) {
    SAnchor& anchor = m_body->AddAnchor(link.Id, link.Pose.Position, link.Pose.Orientation);
    if (link.Group > 0) {
      m_body->MountOnLink(anchor, link.Group);
    }
  }
  if (articulation != nullptr) {
    m_joints = NewComponent<CJointEquippedEntity>(*this, "joints_0", articulation);
  }
  MakeAppearance(assembly);
}

template <typename COMPONENT>
void CPrototypeEntity::AddDevice(TConfigurationNode& node) {
  auto* const component = NewComponent<COMPONENT>(*this, node.Value() + "_0");
  component->Init(node);
  m_devices.push_back(component);
}

void CPrototypeEntity::InitDevices(TConfigurationNode& devices) {
  TConfigurationNodeIterator child;
  for (child = child.begin(&devices); child != child.end(); ++child) {
    const std::string& tag = child->Value();
    CheckIsSingle(*child);
    if (tag == "leds") {
      AddDevice<CLEDEquippedEntity>(*child);
    } else if (tag == "directional_leds") {
      AddDevice<CDirectionalLEDEquippedEntity>(*child);
    } else if (tag == "tags") {
      AddDevice<CTagEquippedEntity>(*child);
    } else if (tag == "simple_radios") {
      AddDevice<CSimpleRadioEquippedEntity>(*child);
    } else if (tag == "magnets") {
      AddDevice<CMagnetEquippedEntity>(*child);
    } else if (tag == "rfid_tags") {
      AddDevice<CRFIDTagEquippedEntity>(*child);
    } else if (tag == "proximity_sensors") {
      InitProximity(*child);
    } else {
      THROW_ARGOSEXCEPTION(OwnerOf(*child)
                           << ": unknown device"
                           << DidYouMean(
                                  tag, {"directional_leds", "leds", "magnets", "proximity_sensors",
                                        "rfid_tags", "simple_radios", "tags"}));
    }
  }
}

void CPrototypeEntity::InitProximity(TConfigurationNode& node) {
  auto* const sensors = NewComponent<CProximitySensorEquippedEntity>(*this, "proximity_0");
  ReadRays(node, [this, sensors](TConfigurationNode& child, const SSensorRay& ray) {
    std::string anchor;
    GetNodeAttribute(child, "anchor", anchor);
    sensors->AddSensor(ray.Offset, ray.Direction, ray.Direction.Length(),
                       m_body->GetAnchor(anchor));
  });
}

void CPrototypeEntity::UpdateComponents() {
  for (CEntity* device : m_devices) {
    if (device->IsEnabled()) {
      device->Update();
    }
  }
}

void CPrototypeEntity::MakeAppearance(const SPrototypeAssembly& assembly) {
  for (size_t i = 0; i < assembly.Links.size(); ++i) {
    SVisualPart part = MakeSolidPart(assembly.Body->Shapes[i], kLinkColors[i % kLinkColors.size()]);
    const SBodyPose inLink =
        Compose(Invert(assembly.Links[i].Pose), {part.Position, part.Orientation});
    part.Position = inLink.Position;
    part.Orientation = inLink.Orientation;
    part.Anchor = assembly.Links[i].Id;
    m_appearance.Parts.push_back(part);
  }
  if (!NodeExists(*GetConfigurationNode(), "devices")) {
    return;
  }
  TConfigurationNode& devices = GetNode(*GetConfigurationNode(), "devices");
  if (!NodeExists(devices, "leds")) {
    return;
  }
  UInt32 number = 0;
  TConfigurationNodeIterator child("led");
  for (child = child.begin(&GetNode(devices, "leds")); child != child.end(); ++child) {
    SVisualPart led;
    led.Kind = SVisualPart::EKind::LED;
    GetNodeAttributeOrDefault(*child, "offset", led.Position, led.Position);
    GetNodeAttributeOrDefault(*child, "anchor", led.Anchor, led.Anchor);
    led.Size = CVector3(kLEDDiameter, kLEDDiameter, kLEDDiameter);
    led.LED = number++;
    m_appearance.Parts.push_back(led);
  }
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CPrototypeEntity)

REGISTER_ENTITY(
    CPrototypeEntity, "prototype", "the authors of this project", "1.0",
    "A robot or object of links, joints and devices.",
    R"(A robot or an object that the experiment file describes: links, joints between them, and devices on them.
The engine dynamics3d moves the joints. A prototype whose joints are all fixed is one rigid body, and may be in any
engine that accepts its solids.

REQUIRED XML

  <arena size="10,10,2">
    <prototype id="p0">
      <body position="0.4,2.3,0" orientation="45,0,0" />
      <links ref="base">
        <link id="base" geometry="box" size="0.1,0.1,0.05" mass="0.5" />
      </links>
    </prototype>
  </arena>

OPTIONAL XML

  <arena size="10,10,2">
    <prototype id="p0" movable="true">
      <body position="0.4,2.3,0" />
      <links ref="base">
        <link id="base" geometry="cylinder" radius="0.05" height="0.05" mass="0.5" position="0,0,0" orientation="0,0,0" />
        <link id="arm" geometry="box" size="0.1,0.02,0.02" mass="0.1" position="0.05,0,0.06" />
        <link id="ball" geometry="sphere" radius="0.02" mass="0.05" />
        <link id="wedge" geometry="convex_hull" mass="0.05">(0,0,0)(0.05,0,0)(0,0.05,0)(0,0,0.05)</link>
      </links>
      <joints>
        <joint id="shoulder" type="revolute" axis="0,1,0" limit="-90:90" disable_collision="true">
          <parent link="base" position="0,0,0.06" orientation="0,0,0" />
          <child link="arm" position="-0.05,0,0" orientation="0,0,0" />
        </joint>
        <joint id="slide" type="prismatic" axis="1,0,0" limit="-0.02:0.02">
          <parent link="arm" position="0.05,0,0.03" />
          <child link="ball" />
        </joint>
        <joint id="glue" type="fixed">
          <parent link="base" position="0.05,0,0" />
          <child link="wedge" />
        </joint>
      </joints>
      <devices>
        <proximity_sensors>
          <sensor anchor="base" offset="0.05,0,0.02" direction="1,0,0" range="0.1" />
          <ring anchor="base" center="0,0,0.02" radius="0.05" start_angle="0" range="0.1" num_sensors="4" />
        </proximity_sensors>
        <magnets>
          <magnet id="tip" anchor="arm" offset="0.05,0,0.01" passive_field="0,0,1" active_field="0,0,-1" />
        </magnets>
      </devices>
    </prototype>
  </arena>

ATTRIBUTES AND CHILDREN

  id                    text, required: unique among the entities of the arena.
  movable               "true" (default) or "false": if false, the reference link is fixed to the world.
  body@position         "x,y,z", m, default "0,0,0": of the body's frame, which moves with the reference link.
  body@orientation      "z,y,x", degrees, default "0,0,0".
  links@ref             text, required: the id of the reference link.
  link@id               text, required: also the name of the link's anchor.
  link@geometry         "box", "cylinder", "sphere" or "convex_hull", required.
  link@size             "x,y,z", m: extents of a box.
  link@radius, @height  m: of a cylinder, upright in the frame of the link, or of a sphere. The text of a
                        convex_hull lists its points, "(x,y,z)(x,y,z)...", m, in the frame of the link.
  link@mass             kg, > 0, required.
  link@position         "x,y,z", m, default "0,0,0": the centre of the base, in the frame of the body.
  link@orientation      "z,y,x", degrees, default "0,0,0". Joints place all links but the reference link: a position
                        that differs is reported.
  joint@id              text, default joint_0, joint_1, ...: unique in the prototype.
  joint@type            "fixed", "prismatic" (moves along its axis), "revolute" (turns about it) or "spherical".
                        Joints form a tree: each link but the reference link is connected to it in one way.
  joint@axis            "x,y,z", required for prismatic and revolute joints: in the frame of the joint.
  joint@limit           "min:max", m or degrees within -180:180, default none: of the position, which is 0 at the start.
  joint@disable_collision  "true" (default) or "false": if true, its two links do not collide with each other.
  parent@link, child@link  text, required: ids of links.
  parent@position, @orientation, child@position, @orientation  as of a body, default 0: the frame of the joint in the
                        frame of that link. Both frames coincide at the start.
  devices               leds, directional_leds, tags, simple_radios, magnets and rfid_tags, with attributes and children
                        as on other robots, and the anchor of a link; and proximity_sensors:
  sensor@anchor         text, required: the id of a link, or "origin".
  sensor@offset, @direction  "x,y,z", m, required: start and direction of the ray, in the frame of the anchor.
  sensor@range          m, > 0, required.
  ring@anchor, @range   as of a sensor.
  ring@center           "x,y,z", m, default "0,0,0": of a horizontal circle in the frame of the anchor.
  ring@radius           m, required. Rays start on the circle and point outward.
  ring@start_angle      degrees, default 0: of the first sensor, counter-clockwise from ahead.
  ring@num_sensors      integer > 0, required.
  controller            as of other robots, optional: config, and the child <params>.
)",
    "Usable")

}  // namespace argos
