#include <argos3/plugins/simulator/visualizations/offscreen/instance_batches.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace instance_batches_test {

using namespace argos;
using Catch::WithinAbs;

namespace {

SMeshInstance MakeInstance(const Eigen::Vector3d& base, double size, std::uint8_t alpha = 255) {
  SMeshInstance instance;
  for (std::size_t row = 0; row < 3; ++row) {
    instance.ToWorld[row] = {0.0f, 0.0f, 0.0f, static_cast<float>(base[static_cast<int>(row)])};
    instance.ToWorld[row][row] = static_cast<float>(size);
  }
  instance.Color = {200, 200, 200, alpha};
  return instance;
}

// at the origin, looking along +x, 90 degrees high and wide
CCamera MakeCamera() {
  SCameraPlacement placement;
  placement.Position = Eigen::Vector3d::Zero();
  placement.LookAt = Eigen::Vector3d::UnitX();
  placement.FocalLength = 13.5;
  return CCamera(placement, 1.0);
}

std::size_t Count(const CInstanceBatches::TBatches& batches) {
  std::size_t count = 0;
  for (const auto& levels : batches) {
    for (const auto& instances : levels) {
      count += instances.size();
    }
  }
  return count;
}

std::size_t CountOpaque(const Eigen::Vector3d& base, double size, int height = 1000) {
  SScene scene;
  scene.OfKind(EMeshKind::Sphere).push_back(MakeInstance(base, size));
  CInstanceBatches batches;
  batches.Fill(scene, MakeCamera(), height, Eigen::Vector3d::UnitZ());
  return Count(batches.GetOpaque());
}

}  // namespace

TEST_CASE("instance batches: solids outside the view are culled",
          "[visualizations][offscreen][batches]") {
  CHECK(CountOpaque({2.0, 0.0, 0.0}, 0.1) == 1);
  CHECK(CountOpaque({2.0, 1.95, 0.0}, 0.1) == 1);
  CHECK(CountOpaque({2.0, 2.5, 0.0}, 0.1) == 0);
  CHECK(CountOpaque({2.0, 0.0, -2.5}, 0.1) == 0);
  CHECK(CountOpaque({-2.0, 0.0, 0.0}, 0.1) == 0);
  // here the eye is inside the solid
  CHECK(CountOpaque({0.0, 0.0, 0.0}, 1.0) == 1);
  // also in front of its centre
  CHECK(CountOpaque({-0.3, 0.0, 0.0}, 1.0) == 1);
}

TEST_CASE("instance batches: solids smaller than a pixel are culled",
          "[visualizations][offscreen][batches]") {
  // 500 pixels per unit of the tangent: 1 mm at 1 m is half a pixel, 1 cm is five
  CHECK(CountOpaque({1.0, 0.0, 0.0}, 0.0005) == 0);
  CHECK(CountOpaque({1.0, 0.0, 0.0}, 0.01) == 1);
  CHECK(CountOpaque({1.0, 0.0, 0.0}, 0.0005, 100000) == 1);
}

TEST_CASE("instance batches: details of a few pixels are culled, other solids of that size are not",
          "[visualizations][offscreen][batches]") {
  // details of two and of twenty pixels
  SScene scene;
  for (const double size : {0.004, 0.04}) {
    SMeshInstance instance = MakeInstance({1.0, 0.0, 0.0}, size);
    scene.OfKind(EMeshKind::Sphere).push_back(instance);
    instance.IsDetail = 1.0f;
    scene.OfKind(EMeshKind::Box).push_back(instance);
  }
  CInstanceBatches batches;
  batches.Fill(scene, MakeCamera(), 1000, Eigen::Vector3d::UnitZ());
  std::size_t spheres = 0;
  std::size_t boxes = 0;
  for (std::size_t level = 0; level < kNumLevels; ++level) {
    spheres += batches.GetOpaque()[static_cast<std::size_t>(EMeshKind::Sphere)][level].size();
    boxes += batches.GetOpaque()[static_cast<std::size_t>(EMeshKind::Box)][level].size();
  }
  CHECK(spheres == 2);
  CHECK(boxes == 1);
}

TEST_CASE("instance batches: the mesh resolution grows with the size on the picture",
          "[visualizations][offscreen][batches]") {
  SScene scene;
  for (const double distance : {1.0, 4.0, 16.0, 64.0}) {
    scene.OfKind(EMeshKind::Cylinder).push_back(MakeInstance({distance, 0.0, 0.0}, 0.3));
  }
  CInstanceBatches batches;
  batches.Fill(scene, MakeCamera(), 1000, Eigen::Vector3d::UnitZ());
  const auto& levels = batches.GetOpaque()[static_cast<std::size_t>(EMeshKind::Cylinder)];
  CHECK(Count(batches.GetOpaque()) == 4);
  CHECK(levels.front().size() == 1);
  CHECK(levels.back().front().ToWorld[0][3] == 1.0f);
  CHECK(levels.front().front().ToWorld[0][3] == 64.0f);
}

TEST_CASE("instance batches: translucent solids are sorted far to near, in runs of one kind",
          "[visualizations][offscreen][batches]") {
  SScene scene;
  scene.OfKind(EMeshKind::Box).push_back(MakeInstance({1.0, 0.0, -0.1}, 0.2, 100));
  scene.OfKind(EMeshKind::Box).push_back(MakeInstance({3.0, 0.0, -0.1}, 0.2, 100));
  scene.OfKind(EMeshKind::Box).push_back(MakeInstance({4.0, 0.0, -0.1}, 0.2, 100));
  scene.OfKind(EMeshKind::Sphere).push_back(MakeInstance({2.0, 0.0, 0.0}, 0.2, 100));
  CInstanceBatches batches;
  batches.Fill(scene, MakeCamera(), 1000, Eigen::Vector3d::UnitZ());
  CHECK(Count(batches.GetOpaque()) == 0);
  REQUIRE(batches.GetTranslucent().size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(batches.GetTranslucent()[i].ToWorld[0][3] == static_cast<float>(4 - i));
  }
  REQUIRE(batches.GetTranslucentRanges().size() == 3);
  CHECK(batches.GetTranslucentRanges()[0].Count == 2);
  CHECK(batches.GetTranslucentRanges()[1].Kind == EMeshKind::Sphere);
  CHECK(batches.GetTranslucentRanges()[2].First == 3);
}

TEST_CASE("instance batches: a solid just outside the view casts its shadow into it",
          "[visualizations][offscreen][batches]") {
  SScene scene;
  scene.OfKind(EMeshKind::Sphere).push_back(MakeInstance({2.0, 2.2, 0.0}, 0.2));
  CInstanceBatches batches;
  batches.Fill(scene, MakeCamera(), 1000, Eigen::Vector3d::UnitZ());
  CHECK(Count(batches.GetOpaque()) == 0);
  CHECK(Count(batches.GetCasters()) == 1);
  CHECK_FALSE(batches.GetCasterBounds().isEmpty());
}

TEST_CASE("instance batches: flying solids outside the view cast shadows according to their height",
          "[visualizations][offscreen][batches]") {
  // The eye is at the ground and sees it between y = -x and y = x. With the sun at 45 degrees in
  // the direction of +y, a shadow extends towards -y by the height of its solid.
  const auto countCasters = [](double y, double height) {
    SScene scene;
    scene.OfKind(EMeshKind::Sphere).push_back(MakeInstance({2.0, y, height}, 0.2));
    CInstanceBatches batches;
    batches.Fill(scene, MakeCamera(), 1000, Eigen::Vector3d(0.0, 1.0, 1.0).normalized());
    return Count(batches.GetCasters());
  };
  CHECK(countCasters(4.5, 3.0) == 1);
  CHECK(countCasters(3.0, 1.2) == 1);
  // 3.2 m outside the view, with a shadow of at most 0.28 m
  CHECK(countCasters(6.5, 0.1) == 0);
  // below the ground there is no surface for a shadow
  CHECK(countCasters(3.0, -5.0) == 0);
}

TEST_CASE("instance batches: bounding spheres contain the solids, depth ranges contain the spheres",
          "[visualizations][offscreen][batches]") {
  // a cube of side 2 standing on (5, 1, 3): centre one higher, half diagonal sqrt(3)
  const SMeshInstance cube = MakeInstance({5.0, 1.0, 3.0}, 2.0);
  const SBoundingSphere sphere = ComputeBoundingSphere(EMeshKind::Box, cube);
  // tolerance of single-precision matrix entries
  CHECK((sphere.Center - Eigen::Vector3d(5.0, 1.0, 4.0)).norm() < 1e-6);
  CHECK_THAT(sphere.Radius, WithinAbs(std::sqrt(3.0), 1e-6));
  SScene scene;
  scene.OfKind(EMeshKind::Box).push_back(cube);
  CInstanceBatches batches;
  batches.Fill(scene, MakeCamera(), 1000, Eigen::Vector3d::UnitZ());
  CHECK_THAT(batches.GetDepths().min().x(), WithinAbs(5.0 - std::sqrt(3.0), 1e-6));
  CHECK_THAT(batches.GetDepths().max().x(), WithinAbs(5.0 + std::sqrt(3.0), 1e-6));
}

TEST_CASE("instance batches: the sun's frame is a rotation whose z axis points to the sun",
          "[visualizations][offscreen][batches]") {
  const Eigen::Vector3d toSun =
      GENERATE(Eigen::Vector3d(-0.4, -0.4, 0.9), Eigen::Vector3d(0.0, 0.0, 1.0),
               Eigen::Vector3d(0.0, 1.0, 0.0))
          .normalized();
  const Eigen::Matrix3d frame = MakeSunFrame(toSun);
  // tolerance of a few roundings of values up to 1
  CHECK((frame * frame.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-12);
  CHECK_THAT(frame.determinant(), WithinAbs(1.0, 1e-12));
  CHECK((frame * toSun - Eigen::Vector3d::UnitZ()).norm() < 1e-12);
}

}  // namespace instance_batches_test
