#include <argos3/plugins/robots/generic/simulator/colored_blob_perspective_camera_default_sensor.h>

#include <argos3/plugins/robots/generic/simulator/device_manual.h>

#include <cmath>

namespace argos {

namespace {

// numbers of the quantities that <noise> may be on
enum : size_t { QUANTITY_X, QUANTITY_Y };

// true if a pixel's coordinate, truncated towards 0, is in an image of that size
bool IsInImage(Real coordinate, SInt32 size) {
  return coordinate > -1.0 && coordinate < size;
}

}  // namespace

// pose of the camera in one tick
class CColoredBlobPerspectiveCameraDefaultSensor::CEye {
 public:
  explicit CEye(const CPerspectiveCameraEquippedEntity& camera)
      : m_position(camera.ComputePosition()),
        m_view(camera.ComputeView()),
        m_ahead(CVector3(CVector3::X).Rotate(m_view)),
        m_toCamera(m_view.Inverse()),
        m_range(camera.GetRange()),
        m_tanAperture(Tan(camera.GetAperture())),
        m_focalLength(camera.GetFocalLength()),
        m_mtWidth(camera.GetImageMtWidth()),
        m_mtHeight(camera.GetImageMtHeight()),
        m_pxWidth(camera.GetImagePxWidth()),
        m_pxHeight(camera.GetImagePxHeight()) {}

  const CVector3& GetPosition() const { return m_position; }

  // contains the image and one pixel more to each side, because decimals of pixels are cut off
  CViewVolume GetVolume() const {
    const auto slopes = [this](Real mtSize, SInt32 pxSize) {
      const Real most = (0.5 * mtSize + mtSize / pxSize) / m_focalLength;
      return CRange<Real>(-most, most);
    };
    return CViewVolume(SFrustum{m_position, -CVector3(CVector3::Y).Rotate(m_view),
                                -CVector3(CVector3::Z).Rotate(m_view), m_ahead,
                                CRange<Real>(0.0, m_range), slopes(m_mtWidth, m_pxWidth),
                                slopes(m_mtHeight, m_pxHeight)});
  }

  // returns false if the point, world frame, is not in the image; otherwise writes its pixel
  bool Project(CVector3 point, Real& x, Real& y) const {
    point -= m_position;
    point.Rotate(m_toCamera);
    const Real ahead = point.GetX();
    const Real squareAside = point.GetY() * point.GetY() + point.GetZ() * point.GetZ();
    const Real radius = ahead * m_tanAperture;  // radius of the cone there
    if (ahead <= 0.0 || ahead >= m_range || squareAside >= radius * radius) {
      return false;
    }
    x = -(m_pxWidth / m_mtWidth) * (m_focalLength * point.GetY() / ahead - 0.5 * m_mtWidth);
    y = -(m_pxHeight / m_mtHeight) * (m_focalLength * point.GetZ() / ahead - 0.5 * m_mtHeight);
    return Contains(x, y);
  }

  bool Contains(Real x, Real y) const {
    return IsInImage(x, m_pxWidth) && IsInImage(y, m_pxHeight);
  }

 private:
  CVector3 m_position;  // m, world frame
  CQuaternion m_view;  // world frame
  CVector3 m_ahead;  // direction of the view, world frame
  CQuaternion m_toCamera;  // its inverse
  Real m_range;  // m
  Real m_tanAperture;
  Real m_focalLength;  // m
  Real m_mtWidth, m_mtHeight;  // m
  SInt32 m_pxWidth, m_pxHeight;  // pixels
};

void CColoredBlobPerspectiveCameraDefaultSensor::SetRobot(CComposableEntity& robot) {
  FindCamera(robot, "perspective_camera");
}

void CColoredBlobPerspectiveCameraDefaultSensor::Init(TConfigurationNode& tree) {
  // noise_std_dev is in pixels
  InitCamera(tree, {"x", "y"}, "perspective camera: shifts of pixels");
}

void CColoredBlobPerspectiveCameraDefaultSensor::Update() {
  StartImage();
  const CEye eye(*m_camera);
  m_sight.Detect(
      *m_medium, eye.GetPosition(), eye.GetVolume(),
      [this, &eye](const CLEDEntity& led, SSightPoint* point) {
        Real x = 0.0;
        Real y = 0.0;
        point->Position = led.GetPosition() + m_sight.FindImage(led.GetPosition());
        return led.IsLit() && eye.Project(point->Position, x, y);
      },
      [&](const CLEDEntity& led, const SSightPoint* point) { AddBlob(eye, led, *point); },
      m_showRays);
  EndImage();
}

void CColoredBlobPerspectiveCameraDefaultSensor::AddBlob(const CEye& eye, const CLEDEntity& led,
                                                         const SSightPoint& point) {
  Real x = 0.0;
  Real y = 0.0;
  eye.Project(point.Position, x, y);
  if (m_shifts != nullptr) {
    x += m_shifts->Gaussian(m_noiseStdDev);
    y += m_shifts->Gaussian(m_noiseStdDev);
  }
  x = m_noise.Apply(QUANTITY_X, x);
  y = m_noise.Apply(QUANTITY_Y, y);
  if (eye.Contains(x, y)) {
    m_blobs.emplace_back(led.GetColor(), static_cast<SInt32>(x), static_cast<SInt32>(y));
  }
}

REGISTER_SENSOR(
    CColoredBlobPerspectiveCameraDefaultSensor, "colored_blob_perspective_camera", "default",
    "the authors of this project", "1.0", "A perspective camera that detects coloured lights.",
    R"(In each tick, every detected LED or light gives one blob: its colour and its pixel (x,y) in an image of
640 x 480 pixels, where (0,0) is the upper left one. LEDs with the same pixel give separate blobs. Blobs are in the
order in which the LEDs were created.

The camera is fixed to its robot. On the foot-bot it is at the front, 0.174249733 m above the base, and looks ahead, or
straight up with perspective_camera_front="false"; on the eye-bot it looks down. With the focal length f, the aperture a
and the range of the robot's camera, and an LED at p in the frame of the camera (x along the view, y left, z up; m), the
LED is detected if
- it is enabled in the medium, and not black;
- it belongs to another robot or object;
- px is less than the range, and the angle between p and the view less than a;
- its pixel is in the image: with the height H = 2 f tan(a) / sqrt(1 + (640/480)^2) and the width W = H 640/480,
  x = -(640/W) (f py/px - W/2) and y = -(480/H) (f pz/px - H/2), decimals cut off;
)" + BlobCameraManual() +
        RequiredSensorXML(
            R"(<colored_blob_perspective_camera implementation="default" medium="leds" />)") +
        MediumXML(R"(<led id="leds" />)", "an LED medium") +
        OptionalXML(
            R"(<colored_blob_perspective_camera implementation="default" medium="leds" show_rays="true" noise_std_dev="2">
    <noise on="x" model="uniform" level="1.5" />
  </colored_blob_perspective_camera>)") +
        R"(
  show_rays      "true" or "false", default "false": visualizations show the lines of sight.
  noise_std_dev  real number s >= 0, pixels, default 0: numbers drawn from N(0,s) are added to x and y before the decimals
                 are cut off. A blob that is then outside the image is not listed.
)" + NoiseManual("x|y", "the coordinates (pixels) of each blob."),
    "Usable")

}  // namespace argos
