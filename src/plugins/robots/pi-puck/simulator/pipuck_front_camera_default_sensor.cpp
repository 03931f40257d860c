#include <argos3/plugins/robots/pi-puck/simulator/pipuck_front_camera_default_sensor.h>

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/simulator/entities/directional_led_entity.h>
#include <argos3/plugins/simulator/entities/read_medium.h>
#include <argos3/plugins/simulator/entities/tag_entity.h>
#include <argos3/plugins/simulator/media/directional_led_medium.h>
#include <argos3/plugins/simulator/media/tag_medium.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/plugins/robots/pi-puck/simulator/pipuck_differential_drive_entity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace argos {

namespace {

// the view begins and ends at these distances along its axis, m
constexpr Real kNear = 0.01;
constexpr Real kFar = 0.5;
constexpr Real kLEDTolerance = 0.01;  // m
// corners of a tag from (-,-), in the order of CTagEntity::ComputeCorners() from (+,+)
constexpr size_t kCornerOrder[] = {2, 3, 0, 1};

}  // namespace

void CPiPuckFrontCameraDefaultSensor::SetRobot(CComposableEntity& robot) {
  // throws unless the robot is a Pi-Puck
  robot.GetComponent<CPiPuckDifferentialDriveEntity>("differential_drive");
  m_robot = &robot.GetComponent<CControllableEntity>("controller");
  m_anchor = &robot.GetComponent<CEmbodiedEntity>("body").GetOriginAnchor();
  m_tagsInSight.SetRobot(robot);
  m_ledsInSight.SetRobot(robot);
}

void CPiPuckFrontCameraDefaultSensor::Init(TConfigurationNode& tree) {
  CCI_PiPuckFrontCameraSensor::Init(tree);
  CSimulator& simulator = m_robot->GetSimulator();
  if (NodeAttributeExists(tree, "tag_medium")) {
    m_tagMedium = &ReadMedium<CTagMedium>(tree, simulator, "a tag medium", "tag_medium");
    m_tagMedium->KeepPoints();
  }
  if (NodeAttributeExists(tree, "directional_led_medium")) {
    m_ledMedium = &ReadMedium<CDirectionalLEDMedium>(
        tree, simulator, "a medium of directional LEDs", "directional_led_medium");
    m_ledMedium->KeepPoints();
  }
  GetNodeAttributeOrDefault(tree, "show_frustum", m_showsFrustum, m_showsFrustum);
  GetNodeAttributeOrDefault(tree, "show_tag_rays", m_showsTagRays, m_showsTagRays);
  GetNodeAttributeOrDefault(tree, "show_led_rays", m_showsLEDRays, m_showsLEDRays);
  Disable();  // the controller may enable it
}

void CPiPuckFrontCameraDefaultSensor::Reset() {
  m_tags.clear();
  m_leds.clear();
  m_extraTicks = 0;
}

void CPiPuckFrontCameraDefaultSensor::Disable() {
  CCI_PiPuckFrontCameraSensor::Disable();
  m_tags.clear();
  m_leds.clear();
}

Real CPiPuckFrontCameraDefaultSensor::GetTimestamp() const {
  return (m_robot->GetSpace().GetSimulationClock() + m_extraTicks) *
         m_robot->GetSimulator().GetTickLength();
}

CVector3 CPiPuckFrontCameraDefaultSensor::ToCamera(const CVector3& point) const {
  return (point - m_position).Rotate(m_orientation.Inverse());
}

bool CPiPuckFrontCameraDefaultSensor::Project(const CVector3& point, CVector2& pixel) const {
  const Real depth = point.GetZ();
  if (depth < kNear || depth > kFar) {
    return false;
  }
  const Real x = m_cFocalLength.GetX() * point.GetX() / depth;
  const Real y = m_cFocalLength.GetY() * point.GetY() / depth;
  pixel.Set(x + m_cPrincipalPoint.GetX(), y + m_cPrincipalPoint.GetY());
  return std::abs(x) <= 0.5 * m_cResolution.GetX() && std::abs(y) <= 0.5 * m_cResolution.GetY();
}

std::vector<CVector3> CPiPuckFrontCameraDefaultSensor::ComputeCorners() const {
  std::vector<CVector3> corners;
  for (const Real depth : {kNear, kFar}) {
    const Real x = 0.5 * m_cResolution.GetX() / m_cFocalLength.GetX() * depth;
    const Real y = 0.5 * m_cResolution.GetY() / m_cFocalLength.GetY() * depth;
    for (const CVector3& corner : {CVector3(-x, -y, depth), CVector3(x, -y, depth),
                                   CVector3(x, y, depth), CVector3(-x, y, depth)}) {
      corners.push_back(CVector3(corner).Rotate(m_orientation) + m_position);
    }
  }
  return corners;
}

CViewVolume CPiPuckFrontCameraDefaultSensor::ComputeVolume() const {
  const Real x = 0.5 * m_cResolution.GetX() / m_cFocalLength.GetX();
  const Real y = 0.5 * m_cResolution.GetY() / m_cFocalLength.GetY();
  return CViewVolume(SFrustum{m_position, CVector3(CVector3::X).Rotate(m_orientation),
                              CVector3(CVector3::Y).Rotate(m_orientation),
                              CVector3(CVector3::Z).Rotate(m_orientation),
                              CRange<Real>(kNear, kFar), CRange<Real>(-x, x), CRange<Real>(-y, y)});
}

void CPiPuckFrontCameraDefaultSensor::Update() {
  m_position = CVector3(POSITION_OFFSET).Rotate(m_anchor->Orientation) + m_anchor->Position;
  m_orientation = m_anchor->Orientation * m_cOrientationOffset;
  const CViewVolume view = ComputeVolume();
  m_tags.clear();
  m_leds.clear();
  if (m_tagMedium != nullptr) {
    FindTags(view);
  }
  if (m_ledMedium != nullptr) {
    FindLEDs(view);
  }
  if (m_showsFrustum) {
    ShowFrustum();
  }
}

void CPiPuckFrontCameraDefaultSensor::FindTags(const CViewVolume& view) {
  m_tagsInSight.Detect(
      *m_tagMedium, m_position, view,
      [this](const CTagEntity& tag, SSightPoint* points) {
        const CVector3 image = m_tagsInSight.FindImage(tag.GetPosition());
        if (!tag.Faces(m_position - image)) {
          return false;
        }
        const std::array<CVector3, 4> corners = tag.ComputeCorners();
        points[0].Position = tag.GetPosition() + image;
        const bool isInView = std::all_of(std::begin(kCornerOrder), std::end(kCornerOrder),
                                          [&, i = size_t{1}](size_t corner) mutable {
                                            points[i].Position = corners[corner] + image;
                                            const bool isInside = Project(
                                                ToCamera(points[i].Position), points[i].Pixel);
                                            ++i;
                                            return isInside;
                                          });
        // the centre is in the view if the corners are
        return isInView && Project(ToCamera(points[0].Position), points[0].Pixel);
      },
      [this](const CTagEntity& tag, const SSightPoint* points) {
        m_tags.emplace_back(
            static_cast<UInt32>(std::strtoul(tag.GetPayload().c_str(), nullptr, 10)),
            ToCamera(points[0].Position), m_orientation.Inverse() * tag.GetOrientation(),
            points[0].Pixel,
            std::array<CVector2, 4>{points[1].Pixel, points[2].Pixel, points[3].Pixel,
                                    points[4].Pixel});
      },
      m_showsTagRays);
}

void CPiPuckFrontCameraDefaultSensor::FindLEDs(const CViewVolume& view) {
  m_ledsInSight.Detect(
      *m_ledMedium, m_position, view,
      [this](const CDirectionalLEDEntity& led, SSightPoint* points) {
        const CVector3 image = m_ledsInSight.FindImage(led.GetPosition());
        points[0].Position = led.GetPosition() + image;
        return led.IsLit() && led.ShinesOn(m_position - image) &&
               Project(ToCamera(points[0].Position), points[0].Pixel);
      },
      [this](const CDirectionalLEDEntity& led, const SSightPoint* points) {
        m_leds.emplace_back(ToCamera(points[0].Position), led.GetColor());
      },
      m_showsLEDRays);
}

CCI_PiPuckFrontCameraSensor::ELedState CPiPuckFrontCameraDefaultSensor::DetectLed(
    const CVector3& position) const {
  const auto nearest =
      std::min_element(m_leds.begin(), m_leds.end(), [&position](const auto& a, const auto& b) {
        return SquareDistance(a.first, position) < SquareDistance(b.first, position);
      });
  if (nearest == m_leds.end() || Distance(nearest->first, position) > kLEDTolerance) {
    return ELedState::OFF;
  }
  const std::pair<CColor, ELedState> states[] = {{CColor::MAGENTA, ELedState::Q1},
                                                 {CColor::ORANGE, ELedState::Q2},
                                                 {CColor::GREEN, ELedState::Q3},
                                                 {CColor::BLUE, ELedState::Q4}};
  const auto* const state =
      std::find_if(std::begin(states), std::end(states),
                   [&nearest](const auto& known) { return known.first == nearest->second; });
  return state != std::end(states) ? state->second : ELedState::OFF;
}

void CPiPuckFrontCameraDefaultSensor::ShowFrustum() const {
  const std::vector<CVector3> corners = ComputeCorners();
  for (size_t i = 0; i < 4; ++i) {
    const size_t next = (i + 1) % 4;
    m_robot->AddCheckedRay(false, CRay3(corners[i], corners[next]));
    m_robot->AddCheckedRay(false, CRay3(corners[i], corners[i + 4]));
    m_robot->AddCheckedRay(false, CRay3(corners[i + 4], corners[next + 4]));
  }
}

REGISTER_SENSOR(
    CPiPuckFrontCameraDefaultSensor, "pipuck_front_camera", "default",
    "the authors of this project", "1.0", "The camera of the Pi-Puck.",
    R"(A camera in front finds the tags that face it and are completely in its image, and tells the colour of a directional LED
at a place that the controller names. It sees from 1 cm to 50 cm ahead, by default 17.7 degrees up and down and 13.5
degrees to each side, because the image lies on its side. Bodies occlude. The camera's own robot is invisible.

The camera is off until the controller enables it.
)" + RequiredSensorXML(R"(<pipuck_front_camera implementation="default" />)") +
        OptionalXML(
            R"(<pipuck_front_camera implementation="default" tag_medium="tags" directional_led_medium="directional_leds" rotation="0"
                       resolution="640,480" principal_point="320,240" focal_length="1000,1000"
                       show_frustum="true" show_tag_rays="true" show_led_rays="true" />)") +
        R"(
  rotation                degrees, default 0: of the camera about the axis of its view.
  resolution              "x,y", pixels, default "640,480": sets the field of view.
  principal_point         "x,y", pixels, default half the resolution.
  focal_length            "x,y", pixels, default "1000,1000".
  tag_medium              text: the id of a medium of tags. Without it no tag is found.
  directional_led_medium  text: the id of a medium of directional LEDs. Without it all LEDs are off.
  show_frustum, show_tag_rays, show_led_rays
                          "true" or "false", default "false": visualizations show the view and the lines of sight.
)",
    "Usable")

}  // namespace argos
