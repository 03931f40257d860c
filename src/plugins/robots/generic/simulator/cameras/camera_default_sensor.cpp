#include <argos3/plugins/robots/generic/simulator/camera_default_sensor.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/utility/string_utilities.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

namespace argos {

void CCameraDefaultSensor::SetRobot(CComposableEntity& robot) {
  m_robot = &robot;
  m_body = &robot.GetComponent<CEmbodiedEntity>("body");
  m_controller = &robot.GetComponent<CControllableEntity>("controller");
}

void CCameraDefaultSensor::Init(TConfigurationNode& tree) {
  CCI_CameraSensor::Init(tree);
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
      THROW_ARGOSEXCEPTION(OwnerOf(tree) << ": there already is a camera \"" << id << "\"");
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
    THROW_ARGOSEXCEPTION(OwnerOf(tree) << ": there is no such algorithm for cameras"
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
      algorithm->Update(camera.Camera);
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

// the twelve edges of the view
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
    "Any number of cameras on any robot, each with algorithms that look at its pictures.",
    R"(Each <camera> is a pinhole camera, fixed to a frame of the robot's body. In its own frame it looks along z;
what is at (x,y,z), in m, is seen at the pixel

  u = fx x / z + cx    v = fy y / z + cy

with the focal length (fx,fy) and the principal point (cx,cy). It is in the picture if z is within the range, u in
[0,width) and v in [0,height). Without an orientation the camera looks up; with orientation="-90,90,0" it looks ahead,
with u to the right and v down, as pictures are stored; with "0,180,0" it looks down, with v to the left.

Each camera has algorithms, whose readings come in the order in which the entities that they find were created:

- led_detector finds LEDs and lights of an LED medium that are not black: colour, and pixel (u,v) as real numbers.
- directional_led_detector finds directional LEDs that are not black, and have the camera within their observable
  angle: colour and pixel.
- tag_detector finds tags that have the camera within their observable angle, and of which the centre and all four
  corners are in the picture and in sight: payload, and the pixels of centre and corners. The first corner is that at
  (+,+) of the tag's frame; the others follow counter-clockwise, as seen on the tag.

Nothing is seen of the camera's own robot, whose body hides nothing. What lies on the surface of another body is not
hidden by it from its own side.

The sensor is disabled until the controller calls Enable(); for Lua controllers it is enabled from the start.

REQUIRED XML

  <controllers>
    <my_controller id="c1">
      <actuators />
      <sensors>
        <cameras implementation="default">
          <camera id="front" anchor="origin" position="0.09,0,0.1" orientation="-90,90,0" range="0.05:2"
                  focal_length="500,500" principal_point="320,240" resolution="640,480">
            <led_detector medium="leds" />
            <tag_detector medium="tags" />
          </camera>
        </cameras>
      </sensors>
      <params />
    </my_controller>
  </controllers>

  id               text, required: unique among the robot's cameras.
  anchor           text, required: the frame of the body that the camera is fixed to, for example "origin".
  position         "x,y,z", m, required: in the frame of the anchor.
  orientation      "z,y,x", degrees, required: in the frame of the anchor.
  range            "min:max", m, 0 <= min < max, required: along the view.
  focal_length     "fx,fy", pixels, > 0, required.
  principal_point  "cx,cy", pixels, required: where what lies straight ahead is seen.
  resolution       "width,height", pixels, > 0, required.
  medium           text, required: the id of a medium of the algorithm's kind.

OPTIONAL XML

  <cameras implementation="default" show_frustum="true">
    <camera id="front" anchor="origin" position="0.09,0,0.1" orientation="-90,90,0" range="0.05:2"
            focal_length="500,500" principal_point="320,240" resolution="640,480">
      <led_detector medium="leds" show_rays="true">
        <noise on="x" model="gaussian" std_dev="0.5" />
      </led_detector>
    </camera>
  </cameras>

  show_frustum  "true" or "false", default "false": the edges of the view are shown by visualizations that can.
  show_rays     "true" or "false", default "false": lines of sight are shown by visualizations that can.
  noise         of an algorithm: any number of children, on "x" (u) or "y" (v) of every pixel, or without "on" on both:
                model "uniform" (level), "gaussian" (std_dev) or "rayleigh" (sigma), with bias and relative="true" if
                need be.
)",
    "Usable")

}  // namespace argos
