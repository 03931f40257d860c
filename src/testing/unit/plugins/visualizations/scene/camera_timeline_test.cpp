#include <argos3/plugins/simulator/visualizations/scene/camera_timeline.h>

#include <argos3/core/utility/configuration/argos_exception.h>

#include <catch2/catch.hpp>

namespace argos::camera_timeline_test {

using Catch::WithinAbs;
using Catch::Matchers::Contains;

namespace {

// tolerance of one or two roundings of values up to 100
constexpr double kRounding = 1e-12;

// slot i can be recognised by its focal length, 10 (i + 1) mm, and by its eye at (i, 0, 1)
CCameraTimeline MakeTimeline(std::uint32_t loop = 0) {
  std::array<SCameraPlacement, kNumPlacements> placements;
  for (std::size_t i = 0; i < kNumPlacements; ++i) {
    placements[i].FocalLength = 10.0 * static_cast<double>(i + 1);
    placements[i].Position = Eigen::Vector3d(static_cast<double>(i), 0.0, 1.0);
  }
  CCameraTimeline timeline(placements);
  timeline.SetLoop(loop);
  return timeline;
}

double FocalLengthAt(const CCameraTimeline& timeline, std::uint32_t tick) {
  return timeline.ComputeAt(tick).FocalLength;
}

}  // namespace

TEST_CASE("camera timeline: without keyframes the camera stays in placement 0",
          "[visualizations][offscreen][timeline]") {
  const CCameraTimeline timeline = MakeTimeline();
  CHECK(FocalLengthAt(timeline, 0) == 10.0);
  CHECK(FocalLengthAt(timeline, 12345) == 10.0);
}

TEST_CASE("camera timeline: a keyframe is valid until the next",
          "[visualizations][offscreen][timeline]") {
  CCameraTimeline timeline = MakeTimeline();
  timeline.AddKeyframe({2, 10});
  timeline.AddKeyframe({4, 20});
  CHECK(FocalLengthAt(timeline, 9) == 10.0);
  CHECK(FocalLengthAt(timeline, 10) == 30.0);
  CHECK(FocalLengthAt(timeline, 19) == 30.0);
  CHECK(FocalLengthAt(timeline, 20) == 50.0);
  CHECK(FocalLengthAt(timeline, 1000000) == 50.0);
}

TEST_CASE("camera timeline: interpolation blends every part of the placements linearly",
          "[visualizations][offscreen][timeline]") {
  CCameraTimeline timeline = MakeTimeline();
  SCameraPlacement placement;
  placement.Position = Eigen::Vector3d(4.0, 8.0, 2.0);
  placement.LookAt = Eigen::Vector3d(0.0, 4.0, 0.0);
  placement.Up = Eigen::Vector3d(0.0, 1.0, 1.0);
  placement.FocalLength = 50.0;
  timeline.SetPlacement(1, placement);
  timeline.AddKeyframe({0, 100});
  timeline.InterpolateFromLastKeyframe();
  timeline.AddKeyframe({1, 200});
  const SCameraPlacement blend = timeline.ComputeAt(125);
  CHECK((blend.Position - Eigen::Vector3d(1.0, 2.0, 1.25)).norm() < kRounding);
  CHECK((blend.LookAt - Eigen::Vector3d(0.0, 1.0, 0.0)).norm() < kRounding);
  CHECK((blend.Up - Eigen::Vector3d(0.0, 0.25, 1.0)).norm() < kRounding);
  CHECK_THAT(blend.FocalLength, WithinAbs(20.0, kRounding));
  CHECK_THAT(FocalLengthAt(timeline, 100), WithinAbs(10.0, kRounding));
  CHECK_THAT(FocalLengthAt(timeline, 200), WithinAbs(50.0, kRounding));
  CHECK_THAT(FocalLengthAt(timeline, 300), WithinAbs(50.0, kRounding));
}

TEST_CASE("camera timeline: a loop repeats and blends from the last keyframe to the first",
          "[visualizations][offscreen][timeline]") {
  CCameraTimeline timeline = MakeTimeline(100);
  timeline.AddKeyframe({0, 20});
  timeline.AddKeyframe({4, 60});
  timeline.InterpolateFromLastKeyframe();
  const std::uint32_t round = GENERATE(0u, 1u, 7u);
  CAPTURE(round);
  CHECK(FocalLengthAt(timeline, 100 * round + 30) == 10.0);
  CHECK_THAT(FocalLengthAt(timeline, 100 * round + 60), WithinAbs(50.0, kRounding));
  // 60 ticks from 50 mm at tick 60 to 10 mm at tick 120
  CHECK_THAT(FocalLengthAt(timeline, 100 * round + 90), WithinAbs(30.0, kRounding));
  CHECK_THAT(FocalLengthAt(timeline, 100 * round + 105), WithinAbs(20.0, kRounding));
}

TEST_CASE(
    "camera timeline: in a loop without interpolation the last keyframe is valid beyond its end",
    "[visualizations][offscreen][timeline]") {
  CCameraTimeline timeline = MakeTimeline(100);
  timeline.AddKeyframe({1, 20});
  timeline.AddKeyframe({3, 100});
  CHECK(FocalLengthAt(timeline, 99) == 20.0);
  CHECK(FocalLengthAt(timeline, 100) == 40.0);
  CHECK(FocalLengthAt(timeline, 119) == 40.0);
  CHECK(FocalLengthAt(timeline, 120) == 20.0);
}

TEST_CASE("camera timeline: a single looping keyframe that interpolates stays in its placement",
          "[visualizations][offscreen][timeline]") {
  const std::uint32_t step = GENERATE(0u, 40u, 100u);
  CAPTURE(step);
  CCameraTimeline timeline = MakeTimeline(100);
  timeline.AddKeyframe({5, step});
  timeline.InterpolateFromLastKeyframe();
  for (const std::uint32_t tick : {0u, 39u, 40u, 99u, 100u, 150u}) {
    CHECK_THAT(FocalLengthAt(timeline, tick), WithinAbs(60.0, kRounding));
  }
}

TEST_CASE("camera timeline: invalid settings are errors", "[visualizations][offscreen][timeline]") {
  CCameraTimeline timeline = MakeTimeline(50);
  CHECK_THROWS_WITH(timeline.InterpolateFromLastKeyframe(), Contains("begins with <interpolate>"));
  CHECK_THROWS_WITH(timeline.AddKeyframe({12, 0}), Contains("no placement 12"));
  CHECK_THROWS_WITH(timeline.SetPlacement(12, SCameraPlacement()), Contains("0 to 11"));
  CHECK_THROWS_WITH(timeline.AddKeyframe({0, 51}), Contains("after the timeline's loop of 50"));
  timeline.AddKeyframe({0, 30});
  CHECK_THROWS_WITH(timeline.AddKeyframe({1, 29}), Contains("steps must not decrease"));
  timeline.InterpolateFromLastKeyframe();
  CHECK_THROWS_WITH(timeline.InterpolateFromLastKeyframe(), Contains("two <interpolate> in a row"));
}

}  // namespace argos::camera_timeline_test
