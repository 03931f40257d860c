#include <argos3/plugins/robots/generic/simulator/colored_blob_omnidirectional_camera_rotzonly_sensor.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>

#include <cmath>

namespace argos {

namespace {

constexpr Real kCmPerM = 100.0;
// numbers of the quantities that <noise> may be on
enum : size_t { QUANTITY_DISTANCE, QUANTITY_ANGLE };

// @return the same direction in [-PI,PI)
CRadians Wrap(CRadians angle) {
  angle.SignedNormalize();
  return angle >= CRadians::PI ? -CRadians::PI : angle;
}

}  // namespace

// pose of the camera in one tick
struct CColoredBlobOmnidirectionalCameraRotZOnlySensor::SEye {
  CVector3 Position;  // m, world frame
  Real Cos, Sin;  // cosine and sine of the robot's yaw
  Real HalfSide;  // half the side of the square field of view on the ground, m
};

void CColoredBlobOmnidirectionalCameraRotZOnlySensor::SetRobot(CComposableEntity& robot) {
  FindCamera(robot, "omnidirectional_camera");
  m_body = &robot.GetComponent<CEmbodiedEntity>("body");
}

void CColoredBlobOmnidirectionalCameraRotZOnlySensor::Init(TConfigurationNode& tree) {
  // noise_std_dev is a fraction of the distance
  InitCamera(tree, {"distance", "angle"}, "omnidirectional camera: shifts of LEDs");
}

void CColoredBlobOmnidirectionalCameraRotZOnlySensor::Update() {
  StartImage();
  const SEye eye = ComputeEye();
  const CVector3& c = eye.Position;
  const SBoundingBox field = {CVector3(c.GetX() - eye.HalfSide, c.GetY() - eye.HalfSide, -c.GetZ()),
                              CVector3(c.GetX() + eye.HalfSide, c.GetY() + eye.HalfSide, c.GetZ())};
  if (eye.HalfSide > 0.0) {
    m_sight.Detect(
        *m_medium, c, CViewVolume(field),
        [this, &eye, &c](const CLEDEntity& led, SSightPoint* point) {
          point->Position = led.GetPosition() + m_sight.FindImage(led.GetPosition());
          const CVector3 toLED = point->Position - c;
          return led.IsLit() && std::abs(toLED.GetX()) < eye.HalfSide &&
                 std::abs(toLED.GetY()) < eye.HalfSide &&
                 std::abs(point->Position.GetZ()) <= c.GetZ();
        },
        [&](const CLEDEntity& led, const SSightPoint* point) { AddBlob(eye, led, *point); },
        m_showRays);
  }
  EndImage();
}

CColoredBlobOmnidirectionalCameraRotZOnlySensor::SEye
CColoredBlobOmnidirectionalCameraRotZOnlySensor::ComputeEye() const {
  const SAnchor& origin = m_body->GetOriginAnchor();
  CRadians yaw;
  CRadians pitch;
  CRadians roll;
  origin.Orientation.ToEulerAngles(yaw, pitch, roll);
  SEye eye;
  SinCos(yaw, eye.Sin, eye.Cos);
  eye.Position = m_camera->GetOffset();
  eye.Position.RotateZ(CVector2(eye.Cos, eye.Sin));
  eye.Position += origin.Position;
  eye.HalfSide = eye.Position.GetZ() * Tan(m_camera->GetAperture());
  return eye;
}

void CColoredBlobOmnidirectionalCameraRotZOnlySensor::AddBlob(const SEye& eye,
                                                              const CLEDEntity& led,
                                                              const SSightPoint& point) {
  const CVector3 toLED = point.Position - eye.Position;
  // position in the robot's frame
  CVector2 seen(eye.Cos * toLED.GetX() + eye.Sin * toLED.GetY(),
                eye.Cos * toLED.GetY() - eye.Sin * toLED.GetX());
  if (m_shifts != nullptr) {
    const Real length = seen.Length() * m_shifts->Gaussian(m_noiseStdDev);
    seen += CVector2(length, CRadians(m_shifts->Uniform(-M_PI, M_PI)));
  }
  const Real distance = m_noise.Apply(QUANTITY_DISTANCE, kCmPerM * seen.Length());
  const CRadians angle(m_noise.Apply(QUANTITY_ANGLE, seen.Angle().GetValue()));
  m_blobs.emplace_back(led.GetColor(), Wrap(angle), std::max(distance, 0.0));
}

REGISTER_SENSOR(
    CColoredBlobOmnidirectionalCameraRotZOnlySensor, "colored_blob_omnidirectional_camera",
    "rot_z_only", "the authors of this project", "1.0",
    "An omnidirectional camera that detects coloured lights, for robots that stay upright.",
    R"(The camera is above the robot and looks down in all directions. In each tick, every detected LED or light
gives one blob: its colour, its angle from straight ahead (rad, in [-PI,PI), counter-clockwise) and its
distance along the ground from the point below the camera (cm). LEDs that are close together give separate blobs.
Blobs are in the order in which the LEDs were created.

With the camera at C (m, world frame; on the foot-bot 0.288699733 m above the base) and the aperture a of the robot,
an LED at P is detected if
- it is enabled in the medium, and not black;
- it belongs to another robot or object;
- |Px - Cx| and |Py - Cy| are less than Cz tan(a): a square in the world frame, whatever the heading of the robot;
- it is not higher than the camera, and not more than Cz below the ground;
)" + BlobCameraManual() +
        RequiredSensorXML(
            R"(<colored_blob_omnidirectional_camera implementation="rot_z_only" medium="leds" />)") +
        MediumXML(R"(<led id="leds" />)", "an LED medium") +
        OptionalXML(
            R"(<colored_blob_omnidirectional_camera implementation="rot_z_only" medium="leds" show_rays="true"
                                       noise_std_dev="0.05">
    <noise on="distance" model="gaussian" std_dev="1" />
  </colored_blob_omnidirectional_camera>)") +
        R"(
  show_rays      "true" or "false", default "false": visualizations show the lines of sight.
  noise_std_dev  real number s >= 0, default 0: each blob is shifted along the ground by its distance times a
                 number drawn from N(0,s), in a direction drawn evenly.
)" + NoiseManual("distance|angle", "the distance (cm) and the angle (rad) of each blob."),
    "Usable")

}  // namespace argos
