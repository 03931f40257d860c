#include <argos3/plugins/simulator/visualizations/offscreen/frame_pipeline.h>

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/testing/support/pictures.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <map>
#include <thread>
#include <vector>

namespace frame_pipeline_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

void FillFrame(CFramePipeline::SFrame& frame, std::uint32_t tick) {
  frame.Tick = tick;
  frame.Placement = ObliqueView();
  frame.Scene.ClearContents();
  frame.Scene.ArenaMin = Eigen::Vector2d(-2.0, -2.0);
  frame.Scene.ArenaMax = Eigen::Vector2d(2.0, 2.0);
  frame.Scene.OfKind(EMeshKind::Box)
      .push_back(MakeInstance({0.1 * tick - 0.5, 0.0, 0.0}, {0.2, 0.2, 0.2}, kRed));
}

}  // namespace

TEST_CASE("frame pipeline: frames are written in order, with the pictures of a renderer alone",
          "[visualizations][offscreen][threads]") {
  std::vector<std::uint32_t> order;
  std::map<std::uint32_t, std::vector<std::uint8_t>> pictures;
  CFramePipeline pipeline(SmallPicture(), [&](const SPicture& picture, std::uint32_t tick) {
    // a slow disk: the queue fills up
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    order.push_back(tick);
    pictures[tick] = picture.Pixels;
  });
  for (std::uint32_t tick = 0; tick < 10; ++tick) {
    FillFrame(pipeline.Acquire(), tick);
    pipeline.Submit();
  }
  pipeline.Finish();
  CHECK(order == std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  CRenderer renderer(SmallPicture());
  for (const std::uint32_t tick : {0u, 4u, 9u}) {
    CAPTURE(tick);
    CFramePipeline::SFrame frame;
    FillFrame(frame, tick);
    renderer.Render(frame.Scene, frame.Placement, frame.Picture);
    CHECK(frame.Picture.Pixels == pictures[tick]);
  }
}

TEST_CASE("frame pipeline: an error ends the frames, is thrown once, and another run can follow",
          "[visualizations][offscreen][threads]") {
  std::vector<std::uint32_t> written;
  CFramePipeline pipeline(SmallPicture(), [&](const SPicture&, std::uint32_t tick) {
    if (tick == 2) {
      THROW_ARGOSEXCEPTION("no space for frame " << tick);
    }
    written.push_back(tick);
  });
  const auto run = [&pipeline](std::uint32_t first) {
    for (std::uint32_t tick = first; tick < first + 20; ++tick) {
      FillFrame(pipeline.Acquire(), tick);
      pipeline.Submit();
    }
    pipeline.Finish();
  };
  CHECK_THROWS_WITH(run(0), Contains("no space for frame 2"));
  CHECK(written == std::vector<std::uint32_t>{0, 1});
  CHECK_NOTHROW(pipeline.Finish());
  CHECK_NOTHROW(run(3));
  CHECK(written.size() == 22);
}

TEST_CASE("frame pipeline: frames that were submitted are written at the end, without Finish()",
          "[visualizations][offscreen][threads]") {
  int written = 0;
  {
    CFramePipeline pipeline(SmallPicture(), [&](const SPicture&, std::uint32_t) { ++written; });
    for (std::uint32_t tick = 0; tick < 3; ++tick) {
      FillFrame(pipeline.Acquire(), tick);
      pipeline.Submit();
    }
    // filling this one failed
    pipeline.Acquire();
    pipeline.Acquire();
  }
  CHECK(written == 3);
}

TEST_CASE("frame pipeline: a renderer that cannot be made is an error of the constructor",
          "[visualizations][offscreen][threads]") {
  SRenderSettings settings = SmallPicture();
  settings.Width = 1 << 20;
  CHECK_THROWS_WITH(CFramePipeline(settings, [](const SPicture&, std::uint32_t) {}),
                    Contains("larger than"));
}

}  // namespace frame_pipeline_test
