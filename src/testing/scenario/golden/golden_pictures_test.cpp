// Compares small pictures of every entity, robot and overlay with those in golden/pictures.
//
// After an intended change of the looks, ARGOS_RENEW_GOLDEN=1 scenario_golden_tests replaces them;
// look at each of them before they are committed.

#include "picture_difference.h"

#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/plugins/simulator/visualizations/offscreen/renderer.h>
#include <argos3/testing/support/paths.h>
#include <argos3/testing/support/temporary_folder.h>

#include <catch2/catch.hpp>

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace golden_pictures_test {

using namespace argos;

namespace {

// Limits of SPictureDifference. The driver in pictures/driver.txt gives 0; others round otherwise
// along edges. "a picture in which little has changed" below shows that these notice one LED.
constexpr double kMean = 0.1;
constexpr double kMax = 6.0;

// the controllers that an arena refers to
std::string MakeControllers(const std::string& arena) {
  const std::string folder = InSourceTree("src/testing/scenario/golden/");
  std::string controllers;
  if (arena.find("config='driver'") != std::string::npos) {
    controllers +=
        "<lua_controller id='driver'><actuators>"
        "<leds implementation='default' medium='leds'/>"
        "<range_and_bearing implementation='default'/>"
        "<differential_steering implementation='default'/></actuators>"
        "<sensors><range_and_bearing implementation='medium' medium='rab'/></sensors>"
        "<params script='" +
        folder + "drive.lua'/></lua_controller>";
  }
  if (arena.find("config='idler'") != std::string::npos) {
    controllers += "<lua_controller id='idler'><actuators/><sensors/><params script='" + folder +
                   "stand.lua'/></lua_controller>";
  }
  if (arena.find("config='seer'") != std::string::npos) {
    controllers +=
        "<lua_controller id='seer'><actuators/><sensors>"
        "<footbot_proximity implementation='default' show_rays='true'/>"
        "<footbot_light implementation='rot_z_only' show_rays='true'/>"
        "<colored_blob_omnidirectional_camera implementation='rot_z_only' medium='leds' "
        "show_rays='true'/></sensors><params script='" +
        folder + "stand.lua'/></lua_controller>";
  }
  return controllers;
}

struct SSubject {
  std::string Name;
  std::string Arena;  // children of <arena>
  double Size = 1.0;  // m, of the arena
  std::string RobotTypes = "";  // <robot_types>, or empty
};

// "<robot_types>...</robot_types>" of one of this project's experiments
std::string RobotTypesOf(const std::string& experiment) {
  std::ifstream in(InSourceTree("experiments/" + experiment + ".argos"));
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  const std::string end = "</robot_types>";
  const size_t first = text.find("<robot_types>");
  const size_t last = text.find(end);
  REQUIRE(last != std::string::npos);
  return text.substr(first, last + end.size() - first);
}

std::string GoldenFile(const std::string& name) {
  return InSourceTree("src/testing/scenario/golden/pictures/" + name + ".png");
}

std::string DescribeDriver() {
  static const std::string description = CRenderer(SRenderSettings()).DescribeDriver();
  return description + "\n";
}

std::string ReadText(const std::string& file) {
  std::ifstream in(file);
  return std::string((std::istreambuf_iterator<char>(in)), {});
}

// the last picture of a run of some ticks; it becomes the golden one on request, if it has a name
SPicture Draw(const SSubject& subject, const std::string& offscreen, const std::string& children,
              double length = 0.2) {
  const CTemporaryFolder folder;
  const std::string size = std::to_string(subject.Size);
  CConfigurationDocument document;
  document.Parse("<argos-configuration><framework><experiment length='" + std::to_string(length) +
                     "' ticks_per_second='10' random_seed='1'/></framework>" + subject.RobotTypes +
                     "<controllers>" + MakeControllers(subject.Arena) +
                     "</controllers><arena size='" + size + "," + size + ",2'>" + subject.Arena +
                     "</arena><physics_engines><dynamics3d id='d'/></physics_engines>"
                     "<media><led id='leds'/><range_and_bearing id='rab'/><rfid id='tags'/></media>"
                     "<visualization><offscreen size='160x120' every='1000' directory='" +
                     folder.GetPath() + "' " + offscreen + ">" + children +
                     "</offscreen></visualization></argos-configuration>",
                 "golden.argos");
  CSimulator simulator;
  const CSimulator::CScope scope(simulator);
  simulator.Load(document);
  simulator.Execute();
  std::string last;
  for (const auto& entry : std::filesystem::directory_iterator(folder.GetPath())) {
    last = std::max(last, entry.path().string());
  }
  REQUIRE_FALSE(last.empty());
  if (getenv("ARGOS_RENEW_GOLDEN") != nullptr && !subject.Name.empty()) {
    std::filesystem::copy_file(last, GoldenFile(subject.Name),
                               std::filesystem::copy_options::overwrite_existing);
    std::ofstream(InSourceTree("src/testing/scenario/golden/pictures/driver.txt"))
        << DescribeDriver();
  }
  return ReadPicture(last);
}

void CheckLike(const std::string& name, const SPicture& picture) {
  const SPictureDifference difference = ComputeDifference(picture, ReadPicture(GoldenFile(name)));
  CHECK(difference.Mean <= kMean);
  CHECK(difference.Most <= kMax);
  // of the driver that drew the golden ones
  if (ReadText(InSourceTree("src/testing/scenario/golden/pictures/driver.txt")) ==
      DescribeDriver()) {
    CHECK(difference.Most == 0.0);
  }
}

std::string Robot(const std::string& type, const std::string& id, const std::string& attributes,
                  const std::string& position) {
  return "<" + type + " id='" + id + "' " + attributes + "><body position='" + position +
         "' orientation='30,0,0'/><controller config='idler'/></" + type + ">";
}

}  // namespace

TEST_CASE("golden pictures: entities and robots from three sides", "[golden][visualizations]") {
  const auto subject = GENERATE(
      SSubject{"box",
               "<box id='b' size='0.4,0.3,0.2' movable='true' mass='1'>"
               "<body position='0,0,0' orientation='30,0,0'/>"
               "<leds medium='leds'><led offset='0.15,0,0.2' anchor='origin' color='red'/>"
               "</leds></box>"},
      SSubject{"cylinder",
               "<cylinder id='c' radius='0.2' height='0.3' movable='false'>"
               "<body position='0,0,0'/></cylinder>"},
      SSubject{"light",
               "<light id='l' position='0,0,0.3' color='yellow' intensity='1' "
               "medium='leds'/>"},
      SSubject{"floor", "<floor id='g' source='image' path='" +
                            InSourceTree("src/testing/scenario/golden/floor.ppm") + "'/>"},
      SSubject{"rfid_tag", "<rfid_tag id='t' position='0,0,0.01' medium='tags'/>", 0.2},
      SSubject{"foot-bot", Robot("foot-bot", "f", "", "0,0,0"), 0.4},
      SSubject{"e-puck", Robot("e-puck", "e", "", "0,0,0"), 0.2},
      SSubject{"eye-bot", Robot("eye-bot", "y", "", "0,0,0"), 0.8},
      SSubject{"prototype",
               "<prototype id='p' movable='true'><body position='0,0,0' orientation='30,0,0'/>"
               "<links ref='base'><link id='base' geometry='box' size='0.3,0.2,0.1' mass='1'/>"
               "<link id='ball' geometry='sphere' radius='0.06' mass='0.1' position='0,0,0.1'/>"
               "</links><joints><joint id='glue' type='fixed'><parent link='base' "
               "position='0,0,0.1'/><child link='ball'/></joint></joints></prototype>",
               0.6},
      SSubject{"khepera-iv", Robot("khepera-iv", "k", "", "0,0,0"), 0.3,
               RobotTypesOf("khepera_lua")},
      SSubject{"kilobot", Robot("kilobot", "k", "", "0,0,0"), 0.08, RobotTypesOf("kilobots_lua")},
      SSubject{"thymio", Robot("thymio", "t", "", "0,0,0"), 0.3, RobotTypesOf("thymio_lua")});
  const std::string view = GENERATE("oblique", "top", "corner");
  CAPTURE(subject.Name, view);
  const SSubject named{subject.Name + "_" + view, subject.Arena, subject.Size, subject.RobotTypes};
  CheckLike(named.Name,
            Draw(named, view == "top" ? "look='dark'" : "", "<camera view='" + view + "'/>"));
}

TEST_CASE("golden pictures: overlays", "[golden][visualizations]") {
  const auto [name, overlay] =
      GENERATE(std::pair<std::string, std::string>{"axes", "<axes size='9'/>"},
               std::pair<std::string, std::string>{"clock", "<clock size='12'/>"},
               std::pair<std::string, std::string>{"headings", "<headings/>"},
               std::pair<std::string, std::string>{"ids", "<ids size='12'/>"},
               std::pair<std::string, std::string>{
                   "legend", "<legend size='12'><entry color='red' text='driving'/></legend>"},
               std::pair<std::string, std::string>{"links", "<links width='2'/>"},
               std::pair<std::string, std::string>{"scale_bar", "<scale_bar size='12'/>"},
               std::pair<std::string, std::string>{"title", "<title text='Golden' size='14'/>"},
               std::pair<std::string, std::string>{"trails", "<trails/>"});
  CAPTURE(name);
  const std::string robots =
      "<foot-bot id='one'><body position='-0.3,-0.2,0'/><controller config='driver'/></foot-bot>"
      "<foot-bot id='two'><body position='-0.2,0.2,0' orientation='20,0,0'/>"
      "<controller config='driver'/></foot-bot>";
  const SSubject named{"overlay_" + name, robots, 1.0};
  CheckLike(named.Name, Draw(named, "", "<overlays>" + overlay + "</overlays>", 2.0));
}

TEST_CASE("golden pictures: views of a full arena", "[golden][visualizations]") {
  const std::string arena =
      "<floor id='g' source='image' path='" +
      InSourceTree("src/testing/scenario/golden/floor.ppm") +
      "'/><light id='l' position='0.4,0.5,0.5' color='yellow' intensity='1' medium='leds'/>"
      "<light id='off' position='-0.4,0.7,0.3' color='cyan' intensity='0' medium='leds'/>"
      "<box id='b' size='0.3,0.1,0.2' movable='false'><body position='-0.6,-0.6,0' "
      "orientation='20,0,0'/></box>"
      "<cylinder id='c' radius='0.1' height='0.3' movable='false'><body position='0.6,-0.6,0.3' "
      "orientation='0,70,30'/></cylinder>"
      "<prototype id='gem' movable='false'><body position='-0.6,0.5,0.1' orientation='10,20,30'/>"
      "<links ref='l'><link id='l' geometry='convex_hull' mass='1'>(0.2,0,0)(-0.1,0.2,0)"
      "(-0.15,-0.15,0)(0.05,0.02,0.15)(0,0,-0.1)</link></links></prototype>"
      "<prototype id='ball' movable='false'><body position='0.1,0.7,0'/>"
      "<links ref='l'><link id='l' geometry='sphere' radius='0.1' mass='1'/></links></prototype>"
      "<pipuck id='p'><body position='0.3,0.1,0'/><controller config='idler'/></pipuck>"
      "<foot-bot id='s'><body position='-0.1,0.2,0'/><controller config='seer'/></foot-bot>"
      "<foot-bot id='f'><body position='-0.35,-0.2,0'/><controller config='driver'/></foot-bot>"
      "<foot-bot id='t'><body position='0.1,-0.4,0' orientation='70,0,0'/>"
      "<controller config='driver'/></foot-bot>"
      "<eye-bot id='y'><body position='0.5,-0.1,0.4'/><controller config='idler'/></eye-bot>";
  const std::string overlays =
      "<overlays><headings/><trails duration='1'/><links/><ids size='8'/><scale_bar size='8'/>"
      "<clock size='8' corner='bottom_right'/></overlays>";
  struct SView {
    std::string Name, Attributes, Children;
  };
  const SView view = GENERATE_COPY(
      SView{"light", "", "<camera view='oblique'/>" + overlays},
      SView{"dark", "look='dark' samples='16'", "<camera view='oblique' lens_focal_length='90'/>"},
      SView{"parallel", "show_grid='false' samples='2'",
            "<camera view='corner' fit='contents' projection='orthographic' margin='0.1'/>"},
      SView{"side", "show_rays='false' show_boundary='false'", "<camera view='side'/>"},
      SView{"front", "look='dark'", "<camera view='front' fit='contents'/>" + overlays},
      SView{"follow", "samples='1'", "<camera view='top' follow='s' reach='0.3'/>"},
      SView{"near", "",
            "<camera><placements><placement index='0' position='-0.5,-0.4,0.15' "
            "look_at='0,0.1,0.1' up='0.1,0,1' lens_focal_length='18'/></placements></camera>"},
      SView{"timeline", "",
            "<camera><placements><placement index='0' position='-1,-1,1' look_at='0,0,0'/>"
            "<placement index='1' position='1,-1,0.5' look_at='0.2,0,0' orthographic_height='1'/>"
            "<placement index='2' position='2,1,1.5' look_at='0,0.1,0' lens_focal_length='40'/>"
            "</placements><timeline loop='40'><keyframe placement='0' step='0'/><interpolate/>"
            "<keyframe placement='2' step='30'/></timeline></camera>"});
  CAPTURE(view.Name);
  const SSubject named{"view_" + view.Name, arena, 2.0};
  CheckLike(named.Name, Draw(named, view.Attributes, view.Children, 1.0));
}

TEST_CASE("golden pictures: ground with a texture", "[golden][visualizations]") {
  const SSubject named{"view_texture",
                       "<box id='b' size='0.3,0.1,0.2' movable='false'><body position='0,0,0'/>"
                       "</box>",
                       1.0};
  CheckLike(named.Name, Draw(named,
                             "ground_texture_size='0.4' ground_texture='" +
                                 InSourceTree("src/testing/scenario/golden/floor.ppm") + "'",
                             "<camera view='corner'/>"));
}

TEST_CASE("golden pictures: a picture in which little has changed is noticed",
          "[golden][visualizations]") {
  const auto draw = [](const std::string& color, const std::string& position) {
    return Draw(
        SSubject{"", "<box id='b' size='0.4,0.3,0.2' movable='false'><body position='" + position +
                         "'/><leds medium='leds'><led offset='0,0,0.2' "
                         "anchor='origin' color='" +
                         color + "'/></leds></box>"},
        "", "");
  };
  const SPicture picture = draw("red", "0,0,0");
  const SPictureDifference same = ComputeDifference(picture, draw("red", "0,0,0"));
  CHECK(same.Mean == 0.0);
  CHECK(same.Most == 0.0);
  CHECK(ComputeDifference(picture, draw("magenta", "0,0,0")).Most > 2.0 * kMax);
  // by a pixel and a half
  CHECK(ComputeDifference(picture, draw("red", "0.015,0,0")).Most > kMax);
}

}  // namespace golden_pictures_test
