#include <argos3/plugins/simulator/visualizations/scene/camera_xml.h>
#include <argos3/plugins/simulator/visualizations/offscreen/offscreen_xml.h>
#include <argos3/testing/support/captured_logs.h>

#include <catch2/catch.hpp>

#include <string>

namespace offscreen_xml_test {

using namespace argos;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

// the root element of a text; the document has the lifetime of the object
class CXml {
 public:
  explicit CXml(const std::string& text) { m_document.Parse(text, "test.argos"); }
  TConfigurationNode& Root() { return m_document.GetRoot(); }

 private:
  CConfigurationDocument m_document;
};

SFrameSeriesSettings ReadOffscreen(const std::string& attributes) {
  return ReadOffscreenSettings(CXml("<offscreen " + attributes + "/>").Root());
}

SQtOpenGlRequest ReadQt(const std::string& children, const std::string& attributes = "") {
  return ReadQtOpenGlRequest(
      CXml("<qt-opengl " + attributes + ">" + children + "</qt-opengl>").Root());
}

CCameraTimeline ReadCameraText(const std::string& children) {
  CCameraTimeline timeline(MakeDefaultPlacements(SArenaBox()));
  CXml xml("<offscreen><camera>" + children + "</camera></offscreen>");
  ReadCamera(xml.Root(), timeline);
  return timeline;
}

}  // namespace

TEST_CASE("offscreen settings: omitted attributes have their documented defaults",
          "[visualizations][offscreen][xml]") {
  const SFrameSeriesSettings settings = ReadOffscreen("");
  CHECK(settings.File.Directory == "out");
  CHECK(settings.File.BaseName == "frame_");
  CHECK(settings.File.Format == "png");
  CHECK(settings.File.Quality == -1);
  CHECK(settings.File.CreateDirectory);
  CHECK(settings.Render.Width == 1280);
  CHECK(settings.Render.Height == 960);
  CHECK(settings.Render.Samples == 4);
  CHECK(settings.Every == 1);
  CHECK(settings.KeepLastFrame);
  CHECK(settings.ShowGrid);
  CHECK(settings.ShowBoundary);
  CHECK(settings.ShowRays);
}

TEST_CASE("offscreen settings: every attribute is read", "[visualizations][offscreen][xml]") {
  const SFrameSeriesSettings settings = ReadOffscreen(
      "directory='d' base_name='b' format='jpg' quality='80' size='320x200' every='7' samples='16' "
      "look='dark' show_grid='false' show_boundary='false' show_rays='false'");
  CHECK(settings.File.Directory == "d");
  CHECK(settings.File.BaseName == "b");
  CHECK(settings.File.Format == "jpg");
  CHECK(settings.File.Quality == 80);
  CHECK(settings.Render.Width == 320);
  CHECK(settings.Render.Height == 200);
  CHECK(settings.Render.Samples == 16);
  CHECK(settings.Render.Look.Background.R == SLook::FromName("dark").Background.R);
  CHECK(settings.Every == 7);
  CHECK_FALSE(settings.ShowGrid);
  CHECK_FALSE(settings.ShowBoundary);
  CHECK_FALSE(settings.ShowRays);
  const SFrameSeriesSettings sides = ReadOffscreen("width='640' height='480'");
  CHECK(sides.Render.Width == 640);
  CHECK(sides.Render.Height == 480);
}

TEST_CASE("offscreen settings: a file, or the format of one, means a film",
          "[visualizations][offscreen][films][xml]") {
  SFrameSeriesSettings settings =
      ReadOffscreen("file='a/b.webm' size='321x240' speed='2.5' fps='25' quality='70'");
  CompleteFilmSettings(settings, 100);
  REQUIRE(settings.Film.has_value());
  CHECK(settings.Film->File == "a/b.webm");
  CHECK(settings.Film->Format == EFilmFormat::Webm);
  CHECK(settings.Film->Speed == 2.5);
  CHECK(settings.Film->FramesPerSecond == 25.0);
  CHECK(settings.Film->Quality == 70);
  CHECK(settings.Render.Width == 322);
  CHECK(settings.Every == 10);
  CHECK_FALSE(settings.KeepLastFrame);
  CHECK(ReadOffscreen("format='gif' size='321x240'").Film->File == "out/film.gif");
  CHECK(ReadOffscreen("format='gif' size='321x240'").Render.Width == 321);
  CHECK(ReadOffscreen("format='mp4' directory='d' base_name='b'").Film->File == "d/b.mp4");
  SFrameSeriesSettings given = ReadOffscreen("file='a.mp4' every='7'");
  CompleteFilmSettings(given, 100);
  CHECK(given.Every == 7);
}

TEST_CASE("offscreen settings: samples are powers of 2 up to 16",
          "[visualizations][offscreen][xml]") {
  for (int samples = 1; samples <= 32; ++samples) {
    CAPTURE(samples);
    const std::string attributes = "samples='" + std::to_string(samples) + "'";
    if (samples <= 16 && (samples & (samples - 1)) == 0) {
      CHECK(ReadOffscreen(attributes).Render.Samples == samples);
    } else {
      CHECK_THROWS_WITH(ReadOffscreen(attributes), Contains("is not 1, 2, 4, 8 or 16"));
    }
  }
}

TEST_CASE("offscreen settings: values out of range are errors with their place",
          "[visualizations][offscreen][xml]") {
  const auto [attributes, complaint] = GENERATE(table<std::string, std::string>({
      {"size='0x480'", "0 pixels are out of range"},
      {"size='640x20000'", "20000 pixels are out of range"},
      {"size='640'", "\"640\" is not a size"},
      {"size='640x480x3'", "is not a size"},
      {"size='-640x480'", "is not a size"},
      {"size='640x480' width='640'", "give the frame's size once"},
      {"width='8'", "from 16 to 16384"},
      {"width='many'", "width"},
      {"every='0'", "\"every\" is 0"},
      {"every='-1'", "every"},
      {"samples='3'", "3 is not 1, 2, 4, 8 or 16"},
      {"look='pretty'", "\"light\" or \"dark\""},
      {"show_grid='1'", "show_grid"},
      {"quality='best'", "quality"},
      {"file='a.avi'", "its name must end in .mp4, .webm or .gif"},
      {"file=''", "its name must end in"},
      {"file='a.mp4' directory='out'", "has both \"file\" and \"directory\""},
      {"file='a.mp4' format='gif'", "has both \"file\" and \"format\""},
      {"file='a.mp4' speed='0'", "\"speed\" is 0; it must be from 0.0001 to 10000"},
      {"file='a.mp4' speed='-1'", "speed"},
      {"file='a.mp4' fps='0.5'", "\"fps\" is 0.5; it must be at least 1"},
      {"file='a.gif' fps='60'", "to 50"},
      {"file='a.mp4' quality='101'", "it must be from 0 to 100"},
      {"speed='2'", "is of films only"},
  }));
  CAPTURE(attributes);
  CHECK_THROWS_WITH(ReadOffscreen(attributes),
                    StartsWith("[FATAL] test.argos:1: <offscreen>") && Contains(complaint));
}

TEST_CASE("qt-opengl: without frame grabbing no frames are requested",
          "[visualizations][offscreen][xml]") {
  const SQtOpenGlRequest request =
      ReadQt("",
             "title='x' autoplay='true' lua_editor='true' invert_mouse='true' "
             "show_boundary='false'");
  CHECK_FALSE(request.WantsFrames);
  CHECK_FALSE(request.HasUserFunctions);
  CHECK_FALSE(request.Frames.ShowBoundary);
}

TEST_CASE("qt-opengl: frame grabbing settings are read", "[visualizations][offscreen][xml]") {
  const SQtOpenGlRequest request = ReadQt(
      "<frame_grabbing directory='frames' base_name='f' format='jpg' quality='90' "
      "headless_grabbing='true' headless_frame_size='800x600' headless_frame_rate='5'/>");
  CHECK(request.WantsFrames);
  CHECK(request.Frames.File.Directory == "frames");
  CHECK(request.Frames.File.BaseName == "f");
  CHECK(request.Frames.File.Format == "jpg");
  CHECK(request.Frames.File.Quality == 90);
  CHECK_FALSE(request.Frames.File.CreateDirectory);
  CHECK(request.Frames.Render.Width == 800);
  CHECK(request.Frames.Render.Height == 600);
  CHECK(request.Frames.Every == 5);
  CHECK_FALSE(request.Frames.KeepLastFrame);
}

TEST_CASE("qt-opengl: frame grabbing has the defaults of ARGoS 3",
          "[visualizations][offscreen][xml]") {
  const SQtOpenGlRequest request = ReadQt("<frame_grabbing/>");
  CHECK(request.WantsFrames);
  CHECK(request.Frames.File.Directory == ".");
  CHECK(request.Frames.Render.Width == 1600);
  CHECK(request.Frames.Render.Height == 1200);
  CHECK(request.Frames.Every == 1);
  CHECK_FALSE(ReadQt("<frame_grabbing headless_grabbing='false'/>").WantsFrames);
}

TEST_CASE("qt-opengl: user functions are reported, malformed values are errors",
          "[visualizations][offscreen][xml]") {
  const SQtOpenGlRequest request = ReadQt("<user_functions label='trails' library='lib/x'/>");
  CHECK(request.HasUserFunctions);
  CHECK_THROWS_WITH(ReadQt("<user_functions/>"), Contains("label"));
  CHECK_THROWS_WITH(ReadQt("", "autoplay='yes'"), Contains("autoplay"));
  CHECK_THROWS_WITH(ReadQt("<frame_grabbing headless_frame_rate='0'/>"),
                    Contains("\"headless_frame_rate\" is 0"));
  CHECK_THROWS_WITH(ReadQt("<frame_grabbing headless_frame_size='big'/>"),
                    Contains("\"big\" is not a size"));
}

TEST_CASE("camera in a file: placements are stored in their slots, other slots keep their defaults",
          "[visualizations][offscreen][xml]") {
  const CCameraTimeline timeline = ReadCameraText(
      "<placements>"
      "<placement index='0' position='1,2,3' look_at='1,0,1' lens_focal_length='35'/>"
      "<placement index='11' position='0,0,5' look_at='0,1,0' up='1,0,0'/>"
      "</placements>");
  CHECK(timeline.GetPlacement(0).Position == Eigen::Vector3d(1.0, 2.0, 3.0));
  CHECK(timeline.GetPlacement(0).LookAt == Eigen::Vector3d(1.0, 0.0, 1.0));
  CHECK(timeline.GetPlacement(0).FocalLength == 35.0);
  // looking along (0,-1,-1): up is (0,-1,1) / sqrt(2)
  CHECK((timeline.GetPlacement(0).Up - Eigen::Vector3d(0.0, -1.0, 1.0).normalized()).norm() <
        1e-12);
  CHECK(timeline.GetPlacement(11).FocalLength == 20.0);
  CHECK(timeline.GetPlacement(11).Up == Eigen::Vector3d::UnitX());
  CHECK(timeline.GetPlacement(3).FocalLength == MakeDefaultPlacements(SArenaBox())[3].FocalLength);
}

TEST_CASE("camera in a file: the older form without <placements> is accepted",
          "[visualizations][offscreen][xml]") {
  const CCameraTimeline timeline = ReadCameraText(
      "<placement idx='0' position='0,-1,2' look_at='0,0,0'"
      " lens_focal_length='28'/>");
  CHECK(timeline.GetPlacement(0).Position == Eigen::Vector3d(0.0, -1.0, 2.0));
  CHECK(timeline.GetPlacement(0).FocalLength == 28.0);
}

TEST_CASE("camera in a file: what is up is said if the camera looks straight down",
          "[visualizations][offscreen][xml]") {
  const auto [up, isWarning] =
      GENERATE(table<std::string, bool>({{"", true}, {"up='0,1,0'", false}}));
  TakeLogErr();
  const CCameraTimeline timeline =
      ReadCameraText("<placement index='0' position='1,2,5' look_at='1,2,0' " + up + "/>");
  const std::string warning = TakeLogErr();
  CHECK((warning.find("the camera looks straight up or down and has no \"up\"") !=
         std::string::npos) == isWarning);
  // to the left is +y, so that up is +x
  CHECK(timeline.GetPlacement(0).Up ==
        (isWarning ? Eigen::Vector3d(1.0, 0.0, 0.0) : Eigen::Vector3d(0.0, 1.0, 0.0)));
}

TEST_CASE("camera in a file: the last keyframe needs no successor of its projection",
          "[visualizations][offscreen][xml]") {
  const std::string loop = GENERATE(std::string(), std::string("loop='100'"));
  const std::string children =
      "<placements>"
      "<placement index='0' position='0,-1,2' look_at='0,0,0' lens_focal_length='10'/>"
      "<placement index='1' position='0,-1,2' look_at='0,0,0' orthographic_height='3'/>"
      "</placements>"
      "<timeline " +
      loop +
      "><keyframe placement='0' step='0'/>"
      "<keyframe placement='1' step='40'/><interpolate/></timeline>";
  const CCameraTimeline timeline = ReadCameraText(children);
  if (loop.empty()) {
    CHECK_NOTHROW(timeline.CheckGlides());
    // it stays
    CHECK(timeline.ComputeAt(1000).OrthographicHeight == 3.0);
  } else {
    CHECK_THROWS_WITH(
        timeline.CheckGlides(),
        Contains("from placement 1 to placement 0, of which only one is orthographic"));
  }
}

TEST_CASE("camera in a file: the timeline moves the camera", "[visualizations][offscreen][xml]") {
  const CCameraTimeline timeline = ReadCameraText(
      "<placements>"
      "<placement index='0' position='0,-1,2' look_at='0,0,0' lens_focal_length='10'/>"
      "<placement index='1' position='0,-1,2' look_at='0,0,0' lens_focal_length='30'/>"
      "</placements>"
      "<timeline loop='100'><keyframe placement='0' step='0'/><interpolate/>"
      "<keyframe placement='1' step='40'/></timeline>");
  CHECK(timeline.ComputeAt(20).FocalLength == 20.0);
  CHECK(timeline.ComputeAt(99).FocalLength == 30.0);
  CHECK(timeline.ComputeAt(110).FocalLength == 15.0);
}

TEST_CASE("camera in a file: invalid values are errors with their place",
          "[visualizations][offscreen][xml]") {
  const auto [text, complaint] = GENERATE(table<std::string, std::string>({
      {"<placements><placement index='12' position='0,0,1' look_at='0,1,0'/></placements>",
       "no placement 12"},
      {"<placements><placement position='0,0,1' look_at='0,1,0'/></placements>", "index"},
      {"<placements><placement index='0' look_at='0,1,0'/></placements>", "position"},
      {"<placements><placement index='0' position='0,0' look_at='0,1,0'/></placements>", "x,y,z"},
      {"<placements><placement index='0' position='0,1,0' look_at='0,1,0'/></placements>",
       "the same point"},
      {"<placement idx='0' position='0,0,1' look_at='0,1,0' lens_focal_length='0'/>",
       "must be positive"},
      {"<timeline><interpolate/></timeline>", "begins with <interpolate>"},
      {"<timeline><keyframe placement='0'/></timeline>", "step"},
      {"<timeline loop='9'><keyframe placement='0' step='10'/></timeline>", "after the timeline's"},
  }));
  CAPTURE(text);
  CHECK_THROWS_WITH(ReadCameraText(text),
                    StartsWith("[FATAL] test.argos:1:") && Contains(complaint));
}

TEST_CASE("offscreen settings: parts of the run are ticks and ranges of ticks",
          "[visualizations][offscreen][xml]") {
  typedef std::vector<std::pair<std::uint32_t, std::uint32_t>> TTicks;
  CHECK(ReadOffscreen("").Ticks.empty());
  CHECK(ReadOffscreen("ticks='0-50,100,550-600'").Ticks == TTicks{{0, 50}, {100, 100}, {550, 600}});
  const std::string text = GENERATE("", "5-3", "1,1", "10-20,15", "a", "-5", "5-", "1-2-3", ",");
  CAPTURE(text);
  CHECK_THROWS_WITH(ReadOffscreen("ticks='" + text + "'"),
                    Contains("test.argos:1: <offscreen>: attribute \"ticks\""));
}

}  // namespace offscreen_xml_test
