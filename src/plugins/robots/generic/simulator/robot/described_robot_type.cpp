#include <argos3/plugins/robots/generic/simulator/described_robot_type.h>

#include <argos3/core/simulator/visualization/solid_part.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/plugins/robots/generic/simulator/described_parts.h>
#include <argos3/plugins/robots/generic/simulator/described_robot_entity.h>
#include <argos3/plugins/robots/generic/simulator/robot_components.h>
#include <argos3/plugins/robots/generic/simulator/visual_parts.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

namespace argos {

namespace {

// values that only views use
constexpr CColor kSolidColor(70, 100, 130);
constexpr CColor kWheelColor(30, 30, 32);
constexpr CColor kGlassColor(214, 216, 220);
constexpr Real kLEDDiameter = 0.008;  // m
constexpr Real kWheelWidth = 0.2;  // share of the diameter

// default gains of propellers, those of an eye-bot: of forces for each kg of the mass, of torques
// for each kg m^2 of the moment of inertia
constexpr SControlGains kPositionGains{20.0, 10.0};  // 1/s^2 and 1/s
constexpr SControlGains kVelocityGains{20.0, 0.0};  // 1/s and 1
constexpr SControlGains kYawGains{50.0, 10.0};  // 1/s^2 and 1/s
constexpr SControlGains kYawRateGains{50.0, 10.0};  // 1/s and 1

const SDescribedRobotType::SDevices& DevicesOf(const CRobotEntity& robot) {
  return static_cast<const CDescribedRobotEntity&>(robot).GetType().Devices;
}

CEntity& MakeDescribedLights(CRobotEntity& robot) {
  return MakeLightSensors(robot, DevicesOf(robot).Lights);
}

CEntity& MakeDescribedGround(CRobotEntity& robot) {
  return MakeGroundSensors(robot, DevicesOf(robot).Ground);
}

CEntity& MakeDescribedRAB(CRobotEntity& robot) {
  return MakeRABComponent(robot, DevicesOf(robot).RABOffset);
}

CEntity& MakeDescribedOmnidirectionalCamera(CRobotEntity& robot) {
  return MakeOmnidirectionalCamera(robot, DevicesOf(robot).OmnidirectionalCameraOffset);
}

CEntity& MakeDescribedPerspectiveCamera(CRobotEntity& robot) {
  // straight up; the rear of the robot is up in the image
  const CQuaternion up(-CRadians::PI_OVER_TWO, CVector3::Y);
  const bool front = robot.GetDeviceParameters().PerspectiveCamera.Front;
  const SDescribedRobotType::SDevices& devices = DevicesOf(robot);
  return MakePerspectiveCamera(
      robot, devices.PerspectiveCameraOffset,
      front ? devices.PerspectiveCameraOrientation : devices.PerspectiveCameraOrientation * up);
}

/** Reads a `<robot-type>`. */
class CTypeReader {
 public:
  explicit CTypeReader(TConfigurationNode& tree) : m_tree(tree) {
    m_type.OnDemand.push_back({"battery", &MakeBattery});
    ReadBody();
    ReadDrive();
    m_type.Proximity = ReadLayout("proximity_sensors");
    ReadLEDs();
    ReadOnDemand("light_sensors", "light_sensors", &MakeDescribedLights,
                 [this](TConfigurationNode&) { m_devices.Lights = ReadLayout("light_sensors"); });
    ReadOnDemand("ground_sensors", "ground_sensors", &MakeDescribedGround,
                 [this](TConfigurationNode& node) { ReadGround(node); });
    ReadOnDemand("range_and_bearing", "rab", &MakeDescribedRAB,
                 [this](TConfigurationNode& node) { ReadRAB(node); });
    ReadOnDemand("omnidirectional_camera", "omnidirectional_camera",
                 &MakeDescribedOmnidirectionalCamera,
                 [this](TConfigurationNode& node) { ReadOmnidirectionalCamera(node); });
    ReadOnDemand("perspective_camera", "perspective_camera", &MakeDescribedPerspectiveCamera,
                 [this](TConfigurationNode& node) { ReadPerspectiveCamera(node); });
    // the model of robots without a battery of their own
    if (NodeExists(tree, "battery")) {
      TConfigurationNode& battery = GetNode(tree, "battery");
      GetNodeAttribute(battery, "discharge_model", m_type.Parameters.Battery.Model);
      m_type.Parameters.Battery.Check(OwnerOf(battery));
    }
  }

  std::unique_ptr<const SDescribedRobotType> Take(const std::string& tag) {
    return std::make_unique<const SDescribedRobotType>(std::move(m_type), m_body, tag, m_devices);
  }

 private:
  void ReadBody() {
    TConfigurationNode& body = GetNode(m_tree, "body");
    ReadIn(kMass, body, "mass", m_body.Mass);
    if (NodeAttributeExists(body, "inertia")) {
      Real inertia = 0.0;
      ReadPositive(body, "inertia", "kg m^2", inertia);
      m_body.PlanarInertia = inertia;
    }
    TConfigurationNodeIterator child("solid");
    for (child = child.begin(&body); child != child.end(); ++child) {
      SShapeDescription solid = ReadSolid(*child);
      CVector3 offset;
      CColor color = kSolidColor;
      GetNodeAttributeOrDefault(*child, "offset", offset, offset);
      GetNodeAttributeOrDefault(*child, "orientation", solid.Orientation, solid.Orientation);
      GetNodeAttributeOrDefault(*child, "color", color, color);
      solid.Offset.Rotate(solid.Orientation);
      solid.Offset += offset;
      m_body.Shapes.push_back(solid);
      m_type.Appearance.Parts.push_back(MakeSolidPart(solid, color));
      m_type.Appearance.Parts.back().Material = ReadMaterial(*child);
    }
    if (m_body.Shapes.empty()) {
      THROW_ARGOSEXCEPTION(OwnerOf(body) << " needs at least one child <solid>");
    }
  }

  // exactly one
  void ReadDrive() {
    const std::vector<std::pair<const char*, void (CTypeReader::*)(TConfigurationNode&)>> kinds = {
        {"differential_drive", &CTypeReader::ReadDifferentialDrive},
        {"planar_drive", &CTypeReader::ReadPlanarDrive},
        {"propellers", &CTypeReader::ReadPropellers}};
    size_t numFound = 0;
    for (const auto& [tag, read] : kinds) {
      if (NodeExists(m_tree, tag)) {
        ++numFound;
        (this->*read)(GetNode(m_tree, tag));
      }
    }
    if (numFound != 1) {
      THROW_ARGOSEXCEPTION(OwnerOf(m_tree) << " needs one of the children <differential_drive>, "
                                              "<planar_drive> and <propellers>, found "
                                           << (numFound == 0 ? "none" : "several"));
    }
  }

  void ReadPlanarDrive(TConfigurationNode& node) {
    SPlanarDriveDescription drive;
    ReadPositive(node, "max_force", "N", drive.MaxForce);
    ReadPositive(node, "max_torque", "N m", drive.MaxTorque);
    m_body.PlanarDrive = drive;
  }

  void ReadPropellers(TConfigurationNode& node) {
    const Real inertia = m_body.PlanarInertia.value_or(m_body.ComputePlanarInertia());
    SPropellersDescription propellers;
    propellers.Position = ReadGains(node, "position_gains", kPositionGains, m_body.Mass, false);
    propellers.Velocity = ReadGains(node, "velocity_gains", kVelocityGains, m_body.Mass, true);
    propellers.Yaw = ReadGains(node, "yaw_gains", kYawGains, inertia, false);
    propellers.YawRate = ReadGains(node, "yaw_rate_gains", kYawRateGains, inertia, true);
    ReadPositive(node, "max_force", "N", propellers.MaxForce);
    ReadPositive(node, "max_torque", "N m", propellers.MaxTorque);
    m_body.Propellers = propellers;
  }

  // "proportional,derivative"
  static SControlGains ReadGains(TConfigurationNode& node, const char* attribute,
                                 const SControlGains& byDefault, Real scale, bool isOfRate) {
    CVector2 gains(scale * byDefault.Proportional, scale * byDefault.Derivative);
    GetNodeAttributeOrDefault(node, attribute, gains, gains);
    // the control of a rate is stable without its derivative, that of a pose is not
    if (!(gains.GetX() > 0.0) || !(isOfRate ? gains.GetY() >= 0.0 : gains.GetY() > 0.0)) {
      THROW_ARGOSEXCEPTION(OwnerOf(node)
                           << ": \"" << attribute
                           << "\" must be \"proportional,derivative\", the first > 0 "
                              "and the second "
                           << (isOfRate ? ">=" : ">") << " 0, found \"" << gains << '"');
    }
    return {gains.GetX(), gains.GetY()};
  }

  void ReadDifferentialDrive(TConfigurationNode& node) {
    SDifferentialDriveDescription drive;
    ReadPositive(node, "wheel_distance", "m", drive.InterwheelDistance);
    ReadPositive(node, "wheel_radius", "m", drive.WheelRadius);
    ReadPositive(node, "max_force", "N", drive.MaxForce);
    ReadPositive(node, "max_torque", "N m", drive.MaxTorque);
    m_body.Drive = drive;
    const Real diameter = 2.0 * drive.WheelRadius;
    const Real width = kWheelWidth * diameter;
    for (const Real side : {1.0, -1.0}) {
      // rotates the axis of the cylinder from z to y
      AddPart(m_type.Appearance, SVisualPart::EKind::Cylinder,
              CVector3(0.0, side * 0.5 * drive.InterwheelDistance + 0.5 * width, drive.WheelRadius),
              CVector3(diameter, diameter, width), kWheelColor, EMaterial::Matte)
          .Orientation.FromAngleAxis(CRadians::PI_OVER_TWO, CVector3::X);
    }
  }

  std::shared_ptr<const SRayLayout> ReadLayout(const char* tag) {
    auto layout = std::make_shared<SRayLayout>();
    if (NodeExists(m_tree, tag)) {
      ReadRays(GetNode(m_tree, tag), [&layout](TConfigurationNode&, const SSensorRay& ray) {
        layout->Rays.push_back(ray);
      });
      layout->ComputeBounds();
    }
    return layout;
  }

  void ReadLEDs() {
    auto leds = std::make_shared<CLEDEquippedEntity::SLayout>();
    if (NodeExists(m_tree, "leds")) {
      TConfigurationNodeIterator child;
      for (child = child.begin(&GetNode(m_tree, "leds")); child != child.end(); ++child) {
        CColor color;
        GetNodeAttributeOrDefault(*child, "color", color, color);
        if (child->Value() == "led") {
          CVector3 offset;
          GetNodeAttribute(*child, "offset", offset);
          leds->AddLED(offset, color);
        } else if (child->Value() == "ring") {
          const SDescribedRing ring(*child, "num_leds");
          leds->AddLEDRing(ring.Center, ring.Radius, ring.Start, ring.Number, color);
        } else {
          THROW_ARGOSEXCEPTION(OwnerOf(*child) << ": unknown child of <leds>"
                                               << DidYouMean(child->Value(), {"led", "ring"}));
        }
      }
    }
    for (size_t i = 0; i < leds->Places.size(); ++i) {
      AddLED(m_type.Appearance, static_cast<UInt32>(i), leds->Places[i].Offset, kLEDDiameter,
             kGlassColor);
    }
    m_type.LEDs = leds;
  }

  template <typename READ>
  void ReadOnDemand(const char* tag, const char* component, CEntity& (*make)(CRobotEntity&),
                    READ&& read) {
    if (NodeExists(m_tree, tag)) {
      read(GetNode(m_tree, tag));
      m_type.OnDemand.push_back({component, make});
    }
  }

  void ReadGround(TConfigurationNode& node) {
    auto layout = std::make_shared<SGroundSensorLayout>();
    TConfigurationNodeIterator child("sensor");
    for (child = child.begin(&node); child != child.end(); ++child) {
      CVector2 offset;
      std::string type = "grayscale";
      GetNodeAttribute(*child, "offset", offset);
      GetNodeAttributeOrDefault(*child, "type", type, type);
      if (type != "grayscale" && type != "black_white") {
        THROW_ARGOSEXCEPTION(OwnerOf(*child) << ": unknown type \"" << type << "\""
                                             << DidYouMean(type, {"black_white", "grayscale"}));
      }
      layout->AddSensor(offset, type == "grayscale" ? SGroundSensorPlace::TYPE_GRAYSCALE
                                                    : SGroundSensorPlace::TYPE_BLACK_WHITE);
    }
    m_devices.Ground = layout;
  }

  void ReadRAB(TConfigurationNode& node) {
    SRABParameters& rab = m_type.Parameters.RAB;
    GetNodeAttributeOrDefault(node, "offset", m_devices.RABOffset, m_devices.RABOffset);
    GetNodeAttribute(node, "range", rab.Range);
    GetNodeAttribute(node, "data_size", rab.DataSize);
    rab.Check(OwnerOf(node));
  }

  void ReadOmnidirectionalCamera(TConfigurationNode& node) {
    SOmnidirectionalCameraParameters& camera = m_type.Parameters.OmnidirectionalCamera;
    GetNodeAttribute(node, "offset", m_devices.OmnidirectionalCameraOffset);
    CDegrees aperture = ToDegrees(camera.Aperture);
    GetNodeAttributeOrDefault(node, "aperture", aperture, aperture);
    camera.Aperture = ToRadians(aperture);
    camera.Check(OwnerOf(node));
  }

  void ReadPerspectiveCamera(TConfigurationNode& node) {
    CQuaternion& orientation = m_devices.PerspectiveCameraOrientation;
    GetNodeAttribute(node, "offset", m_devices.PerspectiveCameraOffset);
    GetNodeAttributeOrDefault(node, "orientation", orientation, orientation);
    m_type.Parameters.PerspectiveCamera.Read(node, "");
  }

  TConfigurationNode& m_tree;
  SRobotType m_type;
  SBodyDescription m_body;
  SDescribedRobotType::SDevices m_devices;
};

}  // namespace

void CDescribedRobotType::Init(TConfigurationNode& tree) {
  std::string id;
  GetNodeAttribute(tree, "id", id);
  m_type = CTypeReader(tree).Take(id);
}

std::unique_ptr<CEntity> CDescribedRobotType::New() const {
  return std::make_unique<CDescribedRobotEntity>(*m_type);
}

REGISTER_ENTITY_TYPE(
    CDescribedRobotType, "robot-type", "the authors of this project", "1.0",
    "A type of robots on wheels or with propellers, described in the experiment file.",
    R"(A child of <robot_types> describes a type of robots, of which the arena may then contain any number, also in
<distribute>: their tag is the id of the type. They have the attributes and children of the built-in robots,
and accept all generic devices for which the type has the parts.

REQUIRED XML

  <robot_types>
    <robot-type id="disc">
      <body mass="0.4">
        <solid geometry="cylinder" radius="0.04" height="0.05" />
      </body>
      <differential_drive wheel_distance="0.06" wheel_radius="0.02" max_force="1.5" max_torque="1.5" />
    </robot-type>
  </robot_types>

OPTIONAL XML

  <robot_types>
    <robot-type id="disc">
      <body mass="0.4" inertia="0.001">
        <solid geometry="cylinder" radius="0.04" height="0.05" offset="0,0,0.002" color="gray30" />
        <solid geometry="box" size="0.02,0.02,0.02" offset="0,0,0.052" orientation="45,0,0" />
      </body>
      <differential_drive wheel_distance="0.06" wheel_radius="0.02" max_force="1.5" max_torque="1.5" />
      <proximity_sensors>
        <ring center="0,0,0.03" radius="0.04" start_angle="22.5" range="0.1" num_sensors="8" />
        <sensor offset="0.04,0,0.01" direction="1,0,-0.2" range="0.05" />
      </proximity_sensors>
      <light_sensors>
        <ring center="0,0,0.03" radius="0.04" range="0.1" num_sensors="8" />
        <sensor offset="0,0.01,0.05" direction="0,0,1" range="1" />
      </light_sensors>
      <ground_sensors>
        <sensor offset="0.03,0.01" type="grayscale" />
      </ground_sensors>
      <leds>
        <ring center="0,0,0.05" radius="0.04" start_angle="0" num_leds="4" color="black" />
        <led offset="0,0,0.07" color="red" />
      </leds>
      <range_and_bearing offset="0,0,0.05" range="0.8" data_size="2" />
      <omnidirectional_camera offset="0,0,0.1" aperture="70" />
      <perspective_camera offset="0.04,0,0.04" orientation="0,0,0" front="true" aperture="30" focal_length="0.035"
                          range="2" />
      <battery discharge_model="time" />
    </robot-type>
    <robot-type id="cart">
      <body mass="1"> <solid geometry="box" size="0.2,0.2,0.1" /> </body>
      <planar_drive max_force="5" max_torque="1" />
    </robot-type>
    <robot-type id="drone">
      <body mass="1"> <solid geometry="sphere" radius="0.1" /> </body>
      <propellers max_force="20" max_torque="1" position_gains="2,3" velocity_gains="4,0" yaw_gains="0.5,0.2"
                  yaw_rate_gains="0.5,0" />
    </robot-type>
  </robot_types>

ATTRIBUTES AND CHILDREN

  id                    text, required: the tag of the robots; not that of another entity.
  body@mass             kg, > 0, required; spread evenly over the solids.
  body@inertia          kg m^2, > 0, default that of the solids: about the vertical axis through the origin, which is
                        half-way between the wheels, on the ground; of a flying robot, at its base.
  solid@geometry        "box" (size), "cylinder" (radius, height), "sphere" (radius) or "convex_hull" (its text lists
                        points, "(x,y,z)(x,y,z)..."), required: at least one solid. All lengths are in m.
  solid@offset          "x,y,z", m, default "0,0,0": centre of its base in the robot's frame.
  solid@orientation     "z,y,x", degrees, default "0,0,0".
  solid@color           a colour, for drawing only.
  solid@material        plastic, matte, metal or glass, for the view <povray>. Default: plastic.
  differential_drive, planar_drive, propellers  how the robot moves; one of them is required:
  differential_drive    two wheels. wheel_distance, wheel_radius: m, > 0. max_force (N), max_torque (N m): > 0, the
                        greatest force and torque with which the wheels push and turn the robot. All required.
  planar_drive          omnidirectional wheels, for the actuator planar_drive. max_force (N), max_torque (N m): the same.
  propellers            the robot flies, for the actuators quadrotor_position and quadrotor_speed. max_force (N),
                        max_torque (N m): > 0, required, limits along each axis and about the vertical.
  propellers@position_gains, @velocity_gains, @yaw_gains, @yaw_rate_gains  "proportional,derivative", > 0
                        (of velocity and yaw rate, the second >= 0):
                        of the controllers of these targets. Force (N) and torque (N m) are gain times error. Default:
                        those of an eye-bot, for the mass and the moment of inertia of the body.
  proximity_sensors, light_sensors  rays that start on a ring and point outward (ring), and single ones (sensor):
  ring@center           "x,y,z", m, default "0,0,0".
  ring@radius           m, >= 0, required.
  ring@start_angle      degrees, default 0: of the first device, counter-clockwise from ahead.
  ring@num_sensors, ring@num_leds  integer > 0, required.
  ring@range, sensor@range  m, > 0, required for rays.
  sensor@offset, @direction  "x,y,z", m, required for rays.
  ground_sensors/sensor  offset: "x,y", m, required. type: "grayscale" (default) or "black_white".
  leds/led, leds/ring   color: default black; offset: "x,y,z", m, required for led.
  range_and_bearing     range (m, >= 0) and data_size (bytes), required: defaults of the robots' rab_range and
                        rab_data_size. offset: "x,y,z", m, default "0,0,0".
  omnidirectional_camera  offset: "x,y,z", m, required. aperture: degrees, default 70.
  perspective_camera    offset: "x,y,z", m, required. orientation: "z,y,x", degrees, default "0,0,0". front, aperture,
                        focal_length, range: as perspective_camera_front and so on of a foot-bot, whose defaults they
                        have.
  battery@discharge_model  text: the model of robots without a child <battery>; default: the charge never falls.
)",
    "Usable")

}  // namespace argos
