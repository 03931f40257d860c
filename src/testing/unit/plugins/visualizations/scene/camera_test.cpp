#include <argos3/plugins/simulator/visualizations/scene/camera.h>
#include <argos3/plugins/simulator/visualizations/scene/camera_framing.h>

#include <argos3/core/utility/configuration/argos_exception.h>

#include <catch2/catch.hpp>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <numbers>

namespace argos::camera_test {

using Catch::WithinAbs;
using Catch::Matchers::Contains;

namespace {

// tolerance of a few roundings of values of the order of 1 to 100
constexpr double kRounding = 1e-12;

SCameraPlacement Make(const Eigen::Vector3d& position, const Eigen::Vector3d& lookAt,
                      double focalLength = 20.0) {
  SCameraPlacement placement;
  placement.Position = position;
  placement.LookAt = lookAt;
  placement.FocalLength = focalLength;
  return placement;
}

void CheckVector(const Eigen::Vector3d& found, const Eigen::Vector3d& expected) {
  CAPTURE(found, expected);
  CHECK((found - expected).norm() < kRounding);
}

}  // namespace

TEST_CASE("camera: the target is in the middle of the picture",
          "[visualizations][offscreen][camera]") {
  const Eigen::Vector3d lookAt(0.3, -0.2, 0.1);
  const double aspectRatio = GENERATE(0.5, 1.0, 16.0 / 9.0);
  CAPTURE(aspectRatio);
  const CCamera camera(Make({2.0, 1.0, 3.0}, lookAt), aspectRatio);
  const Eigen::Vector2d middle = camera.Project(lookAt);
  CHECK_THAT(middle.x(), WithinAbs(0.5, kRounding));
  CHECK_THAT(middle.y(), WithinAbs(0.5, kRounding));
}

TEST_CASE("camera: points at the border of the field of view are at the border of the picture",
          "[visualizations][offscreen][camera]") {
  // looking along +x from the origin, 90 degrees high, twice as wide as high: at depth 3 the
  // picture spans 3 m upwards and 6 m to the left and right, which are +y and -y
  const CCamera camera(Make({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 13.5), 2.0);
  const Eigen::Vector2d topLeft = camera.Project({3.0, 6.0, 3.0});
  CHECK_THAT(topLeft.x(), WithinAbs(0.0, kRounding));
  CHECK_THAT(topLeft.y(), WithinAbs(0.0, kRounding));
  const Eigen::Vector2d bottomRight = camera.Project({3.0, -6.0, -3.0});
  CHECK_THAT(bottomRight.x(), WithinAbs(1.0, kRounding));
  CHECK_THAT(bottomRight.y(), WithinAbs(1.0, kRounding));
  const Eigen::Vector2d inner = camera.Project({4.0, -4.0, 2.0});
  CHECK_THAT(inner.x(), WithinAbs(0.75, kRounding));
  CHECK_THAT(inner.y(), WithinAbs(0.25, kRounding));
}

TEST_CASE("camera: a point behind the eye has no projection",
          "[visualizations][offscreen][camera]") {
  const CCamera camera(Make({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}), 1.0);
  CHECK(std::isnan(camera.Project({-1.0, 0.0, 0.0}).x()));
  CHECK_THAT(camera.ComputeDepth({-1.0, 5.0, 7.0}), WithinAbs(-1.0, kRounding));
}

TEST_CASE("camera: matrices agree with the projection of points",
          "[visualizations][offscreen][camera]") {
  const CCamera camera(Make({1.0, -2.0, 1.5}, {0.2, 0.1, 0.0}, 35.0), 4.0 / 3.0);
  const Eigen::Vector3d point =
      GENERATE(Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(0.5, 0.4, 0.2),
               Eigen::Vector3d(-0.3, 1.0, 0.0));
  const Eigen::Matrix4d matrix =
      camera.ComputeProjectionMatrix(0.1, 10.0) * camera.ComputeViewMatrix();
  const Eigen::Vector4d clip = matrix * point.homogeneous();
  const Eigen::Vector2d share = camera.Project(point);
  CHECK_THAT(0.5 + 0.5 * clip.x() / clip.w(), WithinAbs(share.x(), kRounding));
  CHECK_THAT(0.5 - 0.5 * clip.y() / clip.w(), WithinAbs(share.y(), kRounding));
}

TEST_CASE("camera: depths at the near and far planes are -1 and 1 in clip space",
          "[visualizations][offscreen][camera]") {
  const CCamera camera(Make({0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}), 1.0);
  const Eigen::Matrix4d projection = camera.ComputeProjectionMatrix(0.5, 20.0);
  const Eigen::Vector4d atNear = projection * Eigen::Vector4d(0.0, 0.0, -0.5, 1.0);
  const Eigen::Vector4d atFar = projection * Eigen::Vector4d(0.0, 0.0, -20.0, 1.0);
  CHECK_THAT(atNear.z() / atNear.w(), WithinAbs(-1.0, kRounding));
  CHECK_THAT(atFar.z() / atFar.w(), WithinAbs(1.0, kRounding));
}

TEST_CASE(
    "camera: the derived up vector is perpendicular to the line of sight, in its vertical plane",
    "[visualizations][offscreen][camera]") {
  CheckVector(ComputeDefaultUp({2.0, 0.0, 0.0}), {0.0, 0.0, 1.0});
  CheckVector(ComputeDefaultUp({0.0, -3.0, 0.0}), {0.0, 0.0, 1.0});
  const double half = std::sqrt(0.5);
  CheckVector(ComputeDefaultUp({1.0, 0.0, -1.0}), {half, 0.0, half});
  CheckVector(ComputeDefaultUp({0.0, 5.0, 5.0}), {0.0, -half, half});
}

TEST_CASE("camera: looking straight down, the world's +y is on its left",
          "[visualizations][offscreen][camera]") {
  CHECK(IsVertical({0.0, 0.0, -2.0}));
  CHECK_FALSE(IsVertical({1e-3, 0.0, -2.0}));
  CheckVector(ComputeDefaultUp({0.0, 0.0, -2.0}), {1.0, 0.0, 0.0});
  SCameraPlacement placement = Make({0.0, 0.0, 2.0}, {0.0, 0.0, 0.0});
  placement.Up = ComputeDefaultUp(placement.LookAt - placement.Position);
  const CCamera camera(placement, 1.0);
  CheckVector(camera.GetRight(), {0.0, -1.0, 0.0});
}

TEST_CASE("camera: an up vector along the line of sight is replaced by the derived one",
          "[visualizations][offscreen][camera]") {
  SCameraPlacement placement = Make({0.0, 0.0, 2.0}, {0.0, 0.0, 0.0});
  placement.Up = Eigen::Vector3d::UnitZ();
  const CCamera camera(placement, 1.0);
  CheckVector(camera.GetUp(), {1.0, 0.0, 0.0});
}

TEST_CASE("camera: default placements form a circle around the arena",
          "[visualizations][offscreen][camera]") {
  // |size| = 13 for 3 x 4 x 12
  const SArenaBox arena{{1.0, 2.0, 6.0}, {3.0, 4.0, 12.0}};
  const auto placements = MakeDefaultPlacements(arena);
  CheckVector(placements[0].Position, {14.0, 2.0, 18.0});
  CheckVector(placements[3].Position, {1.0, 15.0, 18.0});
  CheckVector(placements[6].Position, {-12.0, 2.0, 18.0});
  CheckVector(placements[5].LookAt, {1.0, 2.0, 0.0});
  CHECK_THAT(placements[0].FocalLength, WithinAbs(65.0, kRounding));
  // 57.5 + 7.5 cos(120 degrees)
  CHECK_THAT(placements[1].FocalLength, WithinAbs(53.75, kRounding));
  CHECK_THAT(placements[3].FocalLength, WithinAbs(65.0, kRounding));
}

TEST_CASE("camera framing: a view contains its points tightly and centred",
          "[visualizations][offscreen][camera]") {
  const std::string name = GENERATE("oblique", "top", "side", "front", "corner");
  const bool isOrthographic = GENERATE(false, true);
  const double aspectRatio = GENERATE(0.75, 4.0 / 3.0, 3.0);
  const Eigen::Vector3d size =
      GENERATE(Eigen::Vector3d(5.0, 5.0, 0.3), Eigen::Vector3d(40.0, 10.0, 6.0),
               Eigen::Vector3d(0.5, 8.0, 1.0));
  CAPTURE(name, isOrthographic, aspectRatio, size);
  const Eigen::Vector3d corner(-1.0, -6.0, 0.0);
  SView view = SView::FromName(name);
  view.IsOrthographic = isOrthographic;
  CCameraFraming framing(view, aspectRatio, 0.04);
  framing.Extend(corner, corner + size);
  const CCamera camera(framing.ComputePlacement(), aspectRatio);
  CHECK(camera.IsOrthographic() == isOrthographic);
  Eigen::AlignedBox2d frame;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d share(i & 1, (i >> 1) & 1, i >> 2);
    frame.extend(camera.Project(corner + size.cwiseProduct(share)));
  }
  CHECK(frame.min().minCoeff() > 0.0);
  CHECK(frame.max().maxCoeff() < 1.0);
  // one of the two directions is filled but for the margin: 1 / 1.04; both sides of it are touched
  // exactly where no point is nearer than the others
  CHECK_THAT(frame.sizes().maxCoeff(), WithinAbs(1.0 / 1.04, 1e-9));
  // the other one is centred by an iteration over the outermost points
  CHECK_THAT(frame.center().x(), WithinAbs(0.5, 0.02));
  CHECK_THAT(frame.center().y(), WithinAbs(0.5, 0.02));
}

TEST_CASE("camera framing: from above, x is to the right and y upwards",
          "[visualizations][offscreen][camera]") {
  CCameraFraming framing(SView::FromName("top"), 4.0 / 3.0, 0.0);
  framing.Extend({-1.0, -1.0, 0.0}, {1.0, 1.0, 0.0});
  const CCamera camera(framing.ComputePlacement(), 4.0 / 3.0);
  CheckVector(camera.GetRight(), {1.0, 0.0, 0.0});
  CheckVector(camera.GetUp(), {0.0, 1.0, 0.0});
}

TEST_CASE("camera framing: an orthographic view has the scale that its height gives",
          "[visualizations][offscreen][camera]") {
  SView view = SView::FromName("top");
  view.IsOrthographic = true;
  CCameraFraming framing(view, 2.0, 0.1);
  framing.Extend({-1.0, 2.0, 0.0}, {1.0, 5.0, 4.0});
  const SCameraPlacement placement = framing.ComputePlacement();
  // 3 m high and a tenth of it
  CHECK_THAT(placement.OrthographicHeight, WithinAbs(3.3, kRounding));
  const CCamera camera(placement, 2.0);
  const Eigen::Vector2d at = camera.Project({0.33, 3.5, 1.0});
  CHECK_THAT(at.x(), WithinAbs(0.5 + 0.33 / 6.6, kRounding));
  CHECK_THAT(at.y(), WithinAbs(0.5, kRounding));
}

TEST_CASE("camera framing: the eye is not inside of what it shows",
          "[visualizations][offscreen][camera]") {
  // a row along the view: the angle of view contains it from its first point on, so that the eye
  // would be there; it is 5 cm ahead
  CCameraFraming row(SView::FromName("side"), 1.0, 0.0);
  row.Extend({1.0, 2.0, 0.5});
  row.Extend({1.0, 30.0, 0.5});
  SCameraPlacement placement = row.ComputePlacement();
  CheckVector(placement.Position, {1.0, 1.95, 0.5});
  CheckVector(placement.LookAt, {1.0, 16.0, 0.5});
  // in any order, with a point between them
  for (const std::array<double, 3>& order : {std::array<double, 3>{30.0, 2.0, 9.0},
                                             {30.0, 9.0, 2.0},
                                             {9.0, 30.0, 2.0},
                                             {2.0, 30.0, 9.0}}) {
    CCameraFraming other(SView::FromName("side"), 1.0, 0.0);
    for (const double y : order) {
      other.Extend({1.0, y, 0.5});
    }
    CheckVector(other.ComputePlacement().Position, {1.0, 1.95, 0.5});
    CheckVector(other.ComputePlacement().LookAt, {1.0, 16.0, 0.5});
  }
  // a single point
  CCameraFraming point(SView::FromName("top"), 1.0, 0.0);
  point.Extend({1.0, 2.0, 0.5});
  CheckVector(point.ComputePlacement().Position, {1.0, 2.0, 0.55});
  // an orthographic eye is ahead by the height of the picture, which is at least 5 cm
  SView view = SView::FromName("top");
  view.IsOrthographic = true;
  CCameraFraming flat(view, 1.0, 0.0);
  flat.Extend({1.0, 2.0, 0.5});
  placement = flat.ComputePlacement();
  CHECK_THAT(placement.OrthographicHeight, WithinAbs(0.05, kRounding));
  CheckVector(placement.Position, {1.0, 2.0, 0.55});
  // without content, a cube of 10 cm around the origin
  CCameraFraming empty(view, 1.0, 0.0);
  CHECK_THAT(empty.ComputePlacement().OrthographicHeight, WithinAbs(0.1, kRounding));
}

TEST_CASE("camera framing: an unknown view is an error that names the known ones",
          "[visualizations][offscreen][camera]") {
  CHECK_THROWS_WITH(SView::FromName("tpo"),
                    Contains("\"tpo\"") && Contains("corner") && Contains("did you mean \"top\""));
}

TEST_CASE("camera: an orthographic matrix agrees with the projection of points",
          "[visualizations][offscreen][camera]") {
  SCameraPlacement placement = Make({1.0, -2.0, 1.5}, {0.2, 0.1, 0.0});
  placement.OrthographicHeight = 3.0;
  const CCamera camera(placement, 4.0 / 3.0);
  const Eigen::Vector3d point(0.5, 0.4, 0.2);
  const Eigen::Vector4d clip =
      camera.ComputeProjectionMatrix(0.1, 10.0) * camera.ComputeViewMatrix() * point.homogeneous();
  CHECK_THAT(clip.w(), WithinAbs(1.0, kRounding));
  const Eigen::Vector2d share = camera.Project(point);
  CHECK_THAT(0.5 + 0.5 * clip.x(), WithinAbs(share.x(), kRounding));
  CHECK_THAT(0.5 - 0.5 * clip.y(), WithinAbs(share.y(), kRounding));
  placement.OrthographicHeight = -1.0;
  CHECK_THROWS_WITH(CCamera(placement, 1.0), Contains("orthographic_height is -1 m"));
}

TEST_CASE("camera: an eye at its target and a zero focal length are errors",
          "[visualizations][offscreen][camera]") {
  CHECK_THROWS_WITH(CCamera(Make({1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}), 1.0),
                    Contains("the same point (1,2,3)"));
  CHECK_THROWS_WITH(CCamera(Make({1.0, 2.0, 3.0}, {0.0, 0.0, 0.0}, 0.0), 1.0),
                    Contains("lens_focal_length is 0 mm"));
  CHECK_THROWS_AS(CCamera(Make({1.0, 2.0, 3.0}, {0.0, 0.0, 0.0}, -5.0), 1.0), CARGoSException);
}

}  // namespace argos::camera_test
