#include <argos3/plugins/robots/generic/simulator/camera_default_sensor.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/utility/string_utilities.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

namespace argos {

void CCameraDefaultSensor::SetRobot(CComposableEntity& robot) {
  m_robot = &robot;
  m_body = &robot.GetComponent<CEmbodiedEntity>("body");
  m_controller = &robot.GetComponent<CControllableEntity>("controller");
}

void CCameraDefaultSensor::Init(TConfigurationNode& tree) {
  CCI_CameraSensor::Init(tree);
  CCI_CameraSensor::Disable();  // the controller may enable it
  GetNodeAttributeOrDefault(tree, "show_frustum", m_showFrustum, false);
  TConfigurationNodeIterator camera("camera");
  for (camera = camera.begin(&tree); camera != camera.end(); ++camera) {
    AddCamera(*camera);
  }
}

void CCameraDefaultSensor::AddCamera(TConfigurationNode& tree) {
  std::string id;
  GetNodeAttribute(tree, "id", id);
  for (const SInterface& other : m_vecInterfaces) {
    if (other.Id == id) {
      THROW_ARGOSEXCEPTION(OwnerOf(tree) << ": the camera id \"" << id << "\" is used twice");
    }
  }
  SCamera camera = {CPinholeCamera(tree, *m_body), {}};
  std::vector<CCI_CameraSensorAlgorithm*> interfaces;
  TConfigurationNodeIterator algorithm;
  for (algorithm = algorithm.begin(&tree); algorithm != algorithm.end(); ++algorithm) {
    camera.Algorithms.push_back(MakeAlgorithm(*algorithm, id));
    interfaces.push_back(&camera.Algorithms.back()->GetCIAlgorithm());
  }
  m_cameras.push_back(std::move(camera));
  m_vecInterfaces.emplace_back(id, interfaces);
}

std::unique_ptr<CCameraSensorSimulatedAlgorithm> CCameraDefaultSensor::MakeAlgorithm(
    TConfigurationNode& tree, const std::string& camera) {
  typedef CFactory<CCameraSensorSimulatedAlgorithm> TFactory;
  if (!TFactory::Exists(tree.Value())) {
    THROW_ARGOSEXCEPTION(OwnerOf(tree) << ": unknown camera algorithm"
                                       << DidYouMean(tree.Value(), TFactory::GetLabels()));
  }
  std::unique_ptr<CCameraSensorSimulatedAlgorithm> algorithm(TFactory::New(tree.Value()));
  algorithm->SetCamera(*m_robot, camera);
  algorithm->Init(tree);
  return algorithm;
}

void CCameraDefaultSensor::Enable() {
  CCI_CameraSensor::Enable();
  for (SCamera& camera : m_cameras) {
    camera.Camera.SetInUse(true);
  }
}

void CCameraDefaultSensor::Disable() {
  CCI_CameraSensor::Disable();
  for (SCamera& camera : m_cameras) {
    camera.Camera.SetInUse(false);
  }
}

void CCameraDefaultSensor::Update() {
  for (SCamera& camera : m_cameras) {
    camera.Camera.Update();
    for (const auto& algorithm : camera.Algorithms) {
      algorithm->Process(camera.Camera);
      for (const auto& [isObstructed, ray] : algorithm->GetCheckedRays()) {
        m_controller->AddCheckedRay(isObstructed, ray);
      }
    }
    if (m_showFrustum) {
      ShowFrustum(camera.Camera);
    }
  }
}

void CCameraDefaultSensor::Reset() {
  for (SCamera& camera : m_cameras) {
    for (const auto& algorithm : camera.Algorithms) {
      algorithm->Reset();
    }
  }
}

// records the twelve edges of the view
void CCameraDefaultSensor::ShowFrustum(const CPinholeCamera& camera) const {
  const std::array<CVector3, 8> corners = camera.ComputeCorners();
  for (size_t i = 0; i < 4; ++i) {
    const size_t next = (i + 1) % 4;
    m_controller->AddCheckedRay(false, CRay3(corners[i], corners[next]));
    m_controller->AddCheckedRay(false, CRay3(corners[4 + i], corners[4 + next]));
    m_controller->AddCheckedRay(false, CRay3(corners[i], corners[4 + i]));
  }
}

REGISTER_SENSOR(
    CCameraDefaultSensor, "cameras", "default", "the authors of this project", "1.0",
    "Any number of cameras on any robot, with algorithms that process their images.",
    R"(Each <camera> is a pinhole camera, fixed to a frame of the robot's body. In its own frame it looks along z;
a point (x,y,z), in m, appears at the pixel

  u = fx x / z + cx    v = fy y / z + cy

with the focal length (fx,fy) and the principal point (cx,cy). It is in the image if z is within the range, u in
[0,width) and v in [0,height). Without an orientation the camera looks up; with orientation="-90,90,0" it looks ahead,
with u to the right and v down, as images are stored; with "0,180,0" it looks down, with v to the left.

Each camera has algorithms. Their readings are in the order in which the detected entities were created:

- led_detector finds LEDs and lights of an LED medium that are not black: colour, and pixel (u,v) as real numbers.
- directional_led_detector finds directional LEDs that are not black, and have the camera within their observable
  angle: colour and pixel.
- tag_detector finds tags that have the camera within their observable angle, if the centre and all four corners are
  in the image and not occluded: payload, and the pixels of centre and corners. The first corner is the one at (+,+) in
  the tag's frame; the others follow counter-clockwise, as seen on the tag.

A camera does not detect entities of its own robot, and the robot's body occludes nothing. A body does not occlude an
entity on its own surface from the side of that surface.

The sensor is disabled until the controller calls Enable(); for Lua controllers it is enabled from the start.
)" + RequiredSensorXML(R"(<cameras implementation="default">
          <camera id="front" anchor="origin" position="0.09,0,0.1" orientation="-90,90,0" range="0.05:2"
                  focal_length="500,500" principal_point="320,240" resolution="640,480">
            <led_detector medium="leds" />
            <tag_detector medium="tags" />
          </camera>
        </cameras>)") +
        R"(
  id               text, required: unique among the robot's cameras.
  anchor           text, required: the frame of the body that the camera is fixed to, for example "origin".
  position         "x,y,z", m, required: in the frame of the anchor.
  orientation      "z,y,x", degrees, required: in the frame of the anchor.
  range            "min:max", m, 0 <= min < max, required: along the view.
  focal_length     "fx,fy", pixels, > 0, required.
  principal_point  "cx,cy", pixels, required: pixel of a point straight ahead.
  resolution       "width,height", pixels, > 0, required.
  medium           text, required: the id of a medium of the algorithm's kind.
)" + OptionalXML(R"(<cameras implementation="default" show_frustum="true">
    <camera id="front" anchor="origin" position="0.09,0,0.1" orientation="-90,90,0" range="0.05:2"
            focal_length="500,500" principal_point="320,240" resolution="640,480">
      <led_detector medium="leds" show_rays="true">
        <noise on="x" model="gaussian" std_dev="0.5" />
      </led_detector>
      <directional_led_detector medium="directional_leds" show_rays="true">
        <noise on="x" model="gaussian" std_dev="0.5" />
      </directional_led_detector>
      <tag_detector medium="tags" show_rays="true">
        <noise on="x" model="gaussian" std_dev="0.5" />
      </tag_detector>
    </camera>
  </cameras>)") +
        R"(
  show_frustum  "true" or "false", default "false": visualizations show the edges of the view.
  show_rays     "true" or "false", default "false": visualizations show the lines of sight.

Noise is a child of an algorithm, "x" the coordinate u and "y" the coordinate v of each pixel.
)" + NoiseManual("x|y", "the coordinates (pixels)."),
    "Usable")

}  // namespace argos
