// What the overlays add to a picture: shapes, places and texts.

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/visualization/view_drawing.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>
#include <argos3/testing/support/experiment.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace overlays_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

using EKind = SDrawnShape::EKind;

constexpr UInt32 kWidth = 640;  // pixels, of pictures
constexpr UInt32 kHeight = 480;

// Drives straight on at 10 cm/s and sends.
class CDriver : public CCI_Controller {
 public:
  void Init(TConfigurationNode&) override {
    if (HasActuator("range_and_bearing")) {
      GetActuator<CCI_Actuator>("range_and_bearing");
    }
    if (HasActuator("differential_steering")) {
      GetActuator<CCI_DifferentialSteeringActuator>("differential_steering")
          ->SetLinearVelocity(10.0, 10.0);
    }
  }
};

REGISTER_CONTROLLER(CDriver, "overlay_driver")

// two e-pucks a metre apart that drive to the right and upwards, and a foot-bot that cannot hear
// them
CTestWorld MakeWorld() {
  return CTestWorld(SExperiment{
      .Controllers = "<overlay_driver id='drive'><actuators>"
                     "<differential_steering implementation='default'/>"
                     "<range_and_bearing implementation='default'/></actuators>"
                     "<sensors><range_and_bearing implementation='medium' medium='rab'/></sensors>"
                     "<params/></overlay_driver>",
      .Engines = "<kinematics2d id='e' velocity_lag='0'/>",
      .Media = "<range_and_bearing id='rab'/>",
      .ArenaSize = "4,6,2",
      .Arena = "<e-puck id='right' rab_range='2'><body position='0,0,0'/>"
               "<controller config='drive'/></e-puck>"
               "<e-puck id='up' rab_range='0.5'><body position='0,1,0' orientation='90,0,0'/>"
               "<controller config='drive'/></e-puck>"
               "<foot-bot id='deaf' rab_range='0.1' rab_data_size='2'><body position='-1,-2,0'/>"
               "<controller config='drive'/></foot-bot>"});
}

// the overlays of a view
class COverlaysOf {
 public:
  COverlaysOf(CTestWorld& world, const std::string& overlays) : m_world(world) {
    m_document.Parse("<view>\n<overlays>" + overlays + "</overlays></view>", "test.argos");
    const CSimulator::CScope scope(world.GetSimulator());
    m_view.Init(m_document.GetRoot());
    m_view.Observe(world.GetSimulator());
  }
  void Step(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      m_world.Step();
      m_view.Observe(m_world.GetSimulator());
    }
  }
  const CDrawing& Draw() { return m_view.Draw(m_world.GetSimulator(), kWidth, kHeight); }
  std::vector<SDrawnShape> DrawAll(EKind kind) {
    std::vector<SDrawnShape> shapes;
    for (const SDrawnShape& shape : Draw().GetShapes()) {
      if (shape.Kind == kind) {
        shapes.push_back(shape);
      }
    }
    return shapes;
  }
  std::string DrawText(size_t number) {
    const std::vector<SDrawnShape> texts = DrawAll(EKind::Text);
    REQUIRE(texts.size() > number);
    return std::string(Draw().GetText(texts[number]));
  }

 private:
  CTestWorld& m_world;
  CConfigurationDocument m_document;
  CViewDrawing m_view;
};

bool IsAt(const CVector3& found, const CVector3& expected) {
  return Distance(found, expected) < 1e-9;
}

std::string ErrorOf(const std::string& overlays) {
  CTestWorld world = MakeWorld();
  try {
    COverlaysOf view(world, overlays);
  } catch (CARGoSException& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("overlays: the clock says the time and the tick, in a corner", "[overlays]") {
  CTestWorld world = MakeWorld();
  COverlaysOf view(world, "<clock size='20'/><clock corner='bottom_right' tick='false'/>");
  view.Step(12);
  CHECK(view.DrawText(0) == "1.2 s   tick 12");
  CHECK(view.DrawText(1) == "1.2 s");
  const std::vector<SDrawnShape> texts = view.DrawAll(EKind::Text);
  for (const SDrawnShape& text : texts) {
    CHECK(text.Space == SDrawnShape::ESpace::Overlay);
  }
  // the first line is below the upper edge by the letters' size at least
  CHECK(texts[0].Position.GetX() < 20.0);
  CHECK(texts[0].Position.GetY() > 20.0);
  CHECK(texts[0].Position.GetY() < 40.0);
  CHECK(texts[1].Position.GetX() > kWidth - 20.0);
  CHECK(texts[1].Position.GetY() > kHeight - 20.0);
  CHECK(texts[1].Position.GetY() < kHeight);
  const CDrawing& drawing = view.Draw();
  CHECK(drawing.GetStyles()[texts[1].Style].Alignment == STextStyle::EAlignment::Right);
  CHECK(drawing.GetStyles()[texts[0].Style].Size == 20.0);
  // 2.5 % of 480 pixels
  CHECK(drawing.GetStyles()[texts[1].Style].Size == 12.0);
}

TEST_CASE("overlays: regions of engines have an outline inside of each, and its id", "[overlays]") {
  CTestWorld world(SExperiment{
      .Controllers = "",
      .Engines = "<dynamics2d id='left'><boundaries><sides><vertex point='-9,-1'/>"
                 "<vertex point='0,-1'/><vertex point='0,9'/><vertex point='-9,9'/></sides>"
                 "</boundaries></dynamics2d>"
                 "<kinematics2d id='rest'/>"
                 "<dynamics3d id='right'><boundaries><bottom height='0.5'/><sides>"
                 "<vertex point='0,-1'/><vertex point='2,-1'/><vertex point='0,1'/></sides>"
                 "</boundaries></dynamics3d>",
      .ArenaSize = "4,2,4",
      .Arena = ""});
  COverlaysOf view(world, "<regions width='2'/>");
  const std::vector<SDrawnShape> lines = view.DrawAll(EKind::Line);
  // the engine without sides has none
  REQUIRE(lines.size() == 7);
  const std::vector<SDrawnShape> texts = view.DrawAll(EKind::Text);
  REQUIRE(texts.size() == 2);
  CHECK(view.DrawText(0) == "left");
  CHECK(view.DrawText(1) == "right");
  CHECK(texts[0].Color != texts[1].Color);
  // as far as the arena, -2 to 2 and -1 to 1; 0.6 % of 2 m towards the middle: along the diagonal
  // of a square
  const Real gap = 0.012 / std::sqrt(2.0);
  const auto hasLine = [&](const CVector3& start, const CVector3& size) {
    return std::any_of(lines.begin(), lines.end(), [&](const SDrawnShape& line) {
      return IsAt(line.Position, start) && IsAt(line.Size, size);
    });
  };
  CHECK(hasLine(CVector3(-2.0 + gap, -1.0 + gap, 0.003), CVector3(2.0 - 2.0 * gap, 0.0, 0.0)));
  CHECK(hasLine(CVector3(-gap, 1.0 - gap, 0.003), CVector3(-2.0 + 2.0 * gap, 0.0, 0.0)));
  CHECK(lines[0].Pixels == 2.0);
  CHECK(IsAt(texts[0].Position, CVector3(-1.0, 0.0, 0.003)));
  CHECK(lines[4].Position.GetZ() == Approx(0.503));
  COverlaysOf black(world, "<regions color='black' ids='false'/>");
  CHECK(black.DrawAll(EKind::Text).empty());
  CHECK(black.DrawAll(EKind::Line)[4].Color == CColor::BLACK);
}

TEST_CASE("overlays: outlines of regions in a tall arena, and of small ones", "[overlays]") {
  CTestWorld world(SExperiment{
      .Controllers = "",
      .Engines = "<dynamics2d id='small'><boundaries><sides><vertex point='-1,-2'/>"
                 "<vertex point='-0.99,-2'/><vertex point='-0.99,-1.99'/><vertex point='-1,-1.99'/>"
                 "</sides></boundaries></dynamics2d>"
                 "<dynamics2d id='large'><boundaries><sides><vertex point='0,-2'/>"
                 "<vertex point='1,-2'/><vertex point='1,-1'/><vertex point='0,-1'/></sides>"
                 "</boundaries></dynamics2d>",
      .ArenaSize = "2,4,4",
      .Arena = ""});
  COverlaysOf view(world, "<regions/>");
  const std::vector<SDrawnShape> lines = view.DrawAll(EKind::Line);
  REQUIRE(lines.size() == 8);
  // corners go half-way to the middle at most
  CHECK(lines[0].Size.Length() == Approx(0.005));
  // else by 0.6 % of the shorter side of the arena, 2 m, along a diagonal
  CHECK(lines[4].Size.Length() == Approx(1.0 - 2.0 * 0.012 / std::sqrt(2.0)));
}

TEST_CASE("overlays: marks, arrows and ids fit robots that are wider than long", "[overlays]") {
  CTestWorld world(SExperiment{
      .Controllers = "<overlay_driver id='stand'><actuators/><sensors/><params/></overlay_driver>",
      .Engines = "<dynamics3d id='e'/>",
      .Arena = "<prototype id='p' movable='true'><body position='0,0,0'/><links ref='base'>"
               "<link id='base' geometry='box' size='0.1,0.4,0.1' mass='1'/></links>"
               "<controller config='stand'/></prototype>"});
  COverlaysOf view(world, "<marks/><headings/><ids/>");
  const std::vector<SDrawnShape> circles = view.DrawAll(EKind::Circle);
  REQUIRE(circles.size() == 1);
  CHECK(circles[0].Size.GetX() == Approx(0.2));
  // without the tip, 35 % of an arrow as long as the robot is wide
  REQUIRE(view.DrawAll(EKind::Line).size() == 1);
  CHECK(view.DrawAll(EKind::Line)[0].Size.Length() == Approx(0.65 * 0.4));
  REQUIRE(view.DrawAll(EKind::Text).size() == 1);
  CHECK(view.DrawAll(EKind::Text)[0].Position.GetX() > 0.2);
}

TEST_CASE("overlays: title and legend", "[overlays]") {
  CTestWorld world = MakeWorld();
  COverlaysOf view(world,
                   "<title text='Two robots' color='blue'/>"
                   "<legend><entry color='red' text='lost'/><entry color='green' text='found'/>"
                   "</legend>");
  CHECK(view.DrawText(0) == "Two robots");
  CHECK(view.DrawText(1) == "lost");
  CHECK(view.DrawText(2) == "found");
  const std::vector<SDrawnShape> texts = view.DrawAll(EKind::Text);
  CHECK(texts[0].Position.GetX() == 0.5 * kWidth);
  CHECK(texts[0].Color == CColor::BLUE);
  CHECK(texts[1].Position.GetY() < texts[2].Position.GetY());
  const std::vector<SDrawnShape> discs = view.DrawAll(EKind::Point);
  REQUIRE(discs.size() == 2);
  CHECK(discs[0].Color == CColor::RED);
  CHECK(discs[1].Color == CColor::GREEN);
  // the disc is beside its text, and inside the picture
  CHECK(discs[0].Position.GetX() > texts[1].Position.GetX());
  CHECK(discs[0].Position.GetX() + 0.5 * discs[0].Pixels < kWidth);
}

TEST_CASE("overlays: ids are beside the robots, of the requested types", "[overlays]") {
  CTestWorld world = MakeWorld();
  COverlaysOf all(world, "<ids/>");
  REQUIRE(all.DrawAll(EKind::Text).size() == 3);
  CHECK(all.DrawText(0) == "right");
  CHECK(all.DrawText(2) == "deaf");
  const SDrawnShape text = all.DrawAll(EKind::Text)[0];
  auto& robot = world.Get<CEPuckEntity>("right");
  // an e-puck's radius is 3.5 cm
  CHECK(text.Position.GetX() - robot.GetEmbodiedEntity().GetOriginAnchor().Position.GetX() ==
        Approx(0.055));
  CHECK(text.Position.GetZ() > robot.GetEmbodiedEntity().GetBoundingBox().MaxCorner.GetZ());
  COverlaysOf footBots(world, "<ids of='foot-bot'/>");
  REQUIRE(footBots.DrawAll(EKind::Text).size() == 1);
  CHECK(footBots.DrawText(0) == "deaf");
}

TEST_CASE("overlays: arrows point along the heading", "[overlays]") {
  CTestWorld world = MakeWorld();
  COverlaysOf view(world, "<headings of='e-puck' length='0.2' width='3'/>");
  const std::vector<SDrawnShape> lines = view.DrawAll(EKind::Line);
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].Pixels == 3.0);
  // a line from the centre, and a tip that ends at the length; the second robot looks along y
  CHECK(std::abs(lines[0].Size.GetY()) < 1e-12);
  CHECK(lines[0].Size.GetX() > 0.1);
  CHECK(std::abs(lines[1].Size.GetX()) < 1e-12);
  CHECK(lines[1].Size.GetY() > 0.1);
  CHECK(view.DrawAll(EKind::Polygon).size() == 2);
}

TEST_CASE("overlays: a trail is the path of the robot", "[overlays]") {
  CTestWorld world = MakeWorld();
  COverlaysOf view(world, "<trails of='e-puck' fade='false' color='red'/>");
  CHECK(view.DrawAll(EKind::Line).size() == 2);
  view.Step(50);
  // 10 cm/s for 5 s: a point in each tick, and a line of no length to the robot
  std::vector<SDrawnShape> lines = view.DrawAll(EKind::Line);
  CHECK(lines.size() == 2 * 51);
  Real length = 0.0;
  for (size_t i = 0; i < 51; ++i) {
    length += lines[i].Size.Length();
    CHECK(lines[i].Color == CColor::RED);
    if (i > 0) {
      CHECK(IsAt(lines[i].Position, lines[i - 1].Position + lines[i - 1].Size));
    }
  }
  CHECK(length == Approx(0.5));
  SECTION("it is interrupted where the robot is placed elsewhere") {
    const CSimulator::CScope scope(world.GetSimulator());
    CEmbodiedEntity& body = world.Get<CEPuckEntity>("right").GetEmbodiedEntity();
    REQUIRE(body.MoveTo(CVector3(-1.5, 1.5, 0.0), CQuaternion()));
    view.Step(10);
    lines = view.DrawAll(EKind::Line);
    for (const SDrawnShape& line : lines) {
      CHECK(line.Size.Length() < 0.02);
    }
    CHECK(lines.size() == 2 * 61 - 1);
  }
  SECTION("half a metre in a tick is still a path") {
    const Real step = GENERATE(0.4, 0.6);
    const CSimulator::CScope scope(world.GetSimulator());
    CEmbodiedEntity& body = world.Get<CEPuckEntity>("right").GetEmbodiedEntity();
    const CVector3 place = body.GetOriginAnchor().Position;
    REQUIRE(body.MoveTo(place + CVector3(step, 0.0, 0.0), CQuaternion()));
    view.Step(1);
    Real longest = 0.0;
    for (const SDrawnShape& line : view.DrawAll(EKind::Line)) {
      longest = std::max(longest, line.Size.Length());
    }
    // and 1 cm of its own
    CHECK(longest == Approx(step == 0.4 ? 0.41 : 0.01).margin(1e-5));
  }
  SECTION("it begins again after a reset") {
    world.GetSimulator().Reset();
    view.Step(0);
    CHECK(view.DrawAll(EKind::Line).empty());
    view.Step(1);
    CHECK(view.DrawAll(EKind::Line).size() <= 4);
  }
  SECTION("it goes with a removed robot") {
    const CSimulator::CScope scope(world.GetSimulator());
    world.GetSimulator().GetLoopFunctions().RemoveEntity("right");
    view.Step(1);
    CHECK(view.DrawAll(EKind::Line).size() == 52);
  }
}

TEST_CASE("overlays: trails and links do not cross an arena of which sides are joined",
          "[overlays][torus]") {
  SExperiment experiment;
  experiment.Engines = "<kinematics2d id='engine'/>";
  experiment.Media = "<range_and_bearing id='rab'/>";
  experiment.Controllers =
      "<overlay_driver id='drive'><actuators><differential_steering implementation='default'/>"
      "<range_and_bearing implementation='default'/></actuators><sensors><range_and_bearing "
      "implementation='medium' medium='rab'/></sensors></overlay_driver>";
  // smaller than what counts as a jump elsewhere
  experiment.ArenaSize = "0.45,0.45,1";
  experiment.ArenaAttributes = "periodic='true'";
  experiment.Arena =
      "<e-puck id='a' rab_range='0.2'><body position='0.1,0.1,0'/><controller config='drive'/>"
      "</e-puck><e-puck id='b' rab_range='0.2'><body position='-0.2,0.1,0'/>"
      "<controller config='drive'/></e-puck>";
  CTestWorld world(experiment);
  COverlaysOf trails(world, "<trails fade='false'/>");
  COverlaysOf links(world, "<links/>");
  for (int tick = 0; tick < 60; ++tick) {
    trails.Step(1);
    for (const SDrawnShape& line : trails.DrawAll(EKind::Line)) {
      REQUIRE(line.Size.Length() < 0.02);
    }
    const std::vector<SDrawnShape> lines = links.DrawAll(EKind::Line);
    REQUIRE(lines.size() == 2);
    for (const SDrawnShape& line : lines) {
      REQUIRE(line.Size.Length() == Approx(0.075));
    }
  }
}

TEST_CASE("overlays: an old part of a trail fades and ends", "[overlays]") {
  CTestWorld world = MakeWorld();
  COverlaysOf view(world, "<trails of='foot-bot' duration='2'/>");
  view.Step(100);
  const std::vector<SDrawnShape> lines = view.DrawAll(EKind::Line);
  // 2 s at 10 cm/s, at most a point more
  REQUIRE(lines.size() >= 20);
  CHECK(lines.size() <= 22);
  for (size_t i = 1; i < lines.size(); ++i) {
    CHECK(lines[i - 1].Color.GetAlpha() <= lines[i].Color.GetAlpha());
  }
  CHECK(lines.front().Color.GetAlpha() < 30);
  CHECK(lines.back().Color.GetAlpha() == 255);
}

TEST_CASE("overlays: a link is drawn from each receiver half-way to the sender", "[overlays]") {
  CTestWorld world = MakeWorld();
  COverlaysOf view(world, "<links/>");
  CHECK(view.DrawAll(EKind::Line).empty());
  view.Step(1);
  // "right" sends 2 m far, "up" half a metre, the foot-bot 0.1 m, and it is farther from the others
  const std::vector<SDrawnShape> lines = view.DrawAll(EKind::Line);
  REQUIRE(lines.size() == 1);
  const auto placeOf = [&world](const std::string& id) {
    return world.Get<CEPuckEntity>(id).GetRABEquippedEntity().GetPosition();
  };
  CHECK(IsAt(lines[0].Position, placeOf("up")));
  CHECK(IsAt(lines[0].Position + lines[0].Size, 0.5 * (placeOf("up") + placeOf("right"))));
  COverlaysOf other(world, "<links medium='other'/>");
  CHECK(other.DrawAll(EKind::Line).empty());
}

TEST_CASE("overlays: bar and axes fit the arena", "[overlays]") {
  CTestWorld world = MakeWorld();
  COverlaysOf bar(world, "<scale_bar/>");
  // the greatest of 1, 2, 5 times a power of ten below a quarter of 4 m
  CHECK(bar.DrawText(0) == "1 m");
  CHECK(bar.DrawAll(EKind::Line)[0].Size.Length() == Approx(1.0));
  COverlaysOf small(world, "<scale_bar length='0.05'/>");
  CHECK(small.DrawText(0) == "5 cm");
  COverlaysOf axes(world, "<axes/>");
  // at most 8 numbers along 6 m: every 0.5 m; -2 ... 2 and -3 ... 3, and two names
  CHECK(axes.DrawAll(EKind::Text).size() == 9 + 13 + 2);
  CHECK(axes.DrawText(0) == "-2");
  CHECK(axes.DrawText(4) == "0");
  CHECK(axes.DrawText(9) == "x (m)");
}

TEST_CASE("overlays: marks, trails and ids have the colours of a rule", "[overlays]") {
  CTestWorld world = MakeWorld();
  const auto colorsOf = [&](const std::string& rule) {
    std::vector<CColor> colors;
    for (const SDrawnShape& mark :
         COverlaysOf(world, "<marks " + rule + "/>").DrawAll(EKind::Circle)) {
      colors.push_back(mark.Color);
    }
    return colors;
  };
  const auto robots = colorsOf("");
  REQUIRE(robots.size() == 3);
  CHECK((robots[0] != robots[1] && robots[0] != robots[2] && robots[1] != robots[2]));
  CHECK(colorsOf("color_by='robot'") == robots);
  // two e-pucks and a foot-bot, with one controller
  CHECK(colorsOf("color_by='type'") == std::vector<CColor>{robots[0], robots[0], robots[1]});
  CHECK(colorsOf("color_by='team'") == std::vector<CColor>(3, robots[0]));
  CHECK(colorsOf("color='#0a0b0c'") == std::vector<CColor>(3, CColor(10, 11, 12)));
  // no LED is lit: no mark
  CHECK(colorsOf("color_by='led'").empty());
  world.Get<CEPuckEntity>("up").GetLEDEquippedEntity().SetLEDColor(3, CColor::ORANGE);
  CHECK(colorsOf("color_by='led'") == std::vector<CColor>{CColor::ORANGE});
  // x is 0, 0 and -1 m; values beyond the ends have the colours of the ends
  const CColor low(68, 1, 84);
  const CColor high(253, 231, 37);
  CHECK(colorsOf("color_by='pose' min='-3' max='-2'") == std::vector<CColor>(3, high));
  CHECK(colorsOf("color_by='pose' min='0' max='1'") == std::vector<CColor>(3, low));
  CHECK(colorsOf("color_by='pose' min='-1' max='1'")[0] == CColor(33, 144, 141));
  // halfway between two places of the scale
  CHECK(colorsOf("color_by='pose' min='-1' max='15'")[0] == CColor(70, 23, 103));
  world.Get<CEPuckEntity>("up").GetControllableEntity().GetController().RecordValue("food", 2.0);
  CHECK(colorsOf("color_by='value:food' max='2'") == std::vector<CColor>{high});

  COverlaysOf trails(world, "<trails color_by='type' fade='false'/>");
  trails.Step(3);
  CHECK(trails.DrawAll(EKind::Line)[0].Color == robots[0]);
  CHECK(trails.DrawAll(EKind::Line).back().Color == robots[1]);
  CHECK(COverlaysOf(world, "<ids color_by='type'/>").DrawAll(EKind::Text)[2].Color == robots[1]);

  CHECK_THAT(ErrorOf("<marks color_by='sped'/>"),
             Contains("test.argos:2") && Contains("neither robot, type, team or led, nor a field"));
  CHECK_THAT(ErrorOf("<marks color_by='pose' min='1'/>"),
             Contains("\"min\" must be below \"max\", got 1 and 1"));
  CHECK_THAT(ErrorOf("<trails color='red' color_by='type'/>"),
             Contains("cannot be given together"));
}

TEST_CASE("overlays: texts are white in a dark view", "[overlays]") {
  CTestWorld world = MakeWorld();
  const CSimulator::CScope scope(world.GetSimulator());
  for (const auto& [look, color] :
       {std::pair("dark", CColor::WHITE), std::pair("light", CColor::BLACK)}) {
    CConfigurationDocument document;
    document.Parse(std::string("<view look='") + look +
                       "'><overlays><ids/><clock/><title text='t' color='red'/></overlays></view>",
                   "test.argos");
    CViewDrawing view;
    view.Init(document.GetRoot());
    view.Observe(world.GetSimulator());
    const std::vector<SDrawnShape>& shapes =
        view.Draw(world.GetSimulator(), kWidth, kHeight).GetShapes();
    REQUIRE(shapes.size() == 5);
    for (size_t i = 0; i < 4; ++i) {
      CHECK(shapes[i].Color == color);
    }
    CHECK(shapes[4].Color == CColor::RED);
  }
}

TEST_CASE("overlays: errors give the place in the file", "[overlays]") {
  CHECK_THAT(ErrorOf("<trail/>"), Contains("test.argos:2: <trail>") && Contains("trails"));
  CHECK_THAT(ErrorOf("<clock corner='left'/>"),
             Contains("test.argos:2") && Contains("\"left\"") && Contains("bottom_left"));
  CHECK_THAT(ErrorOf("<clock size='0'/>"), Contains("test.argos:2") && Contains("\"size\""));
  CHECK_THAT(ErrorOf("<title/>"), Contains("test.argos:2") && Contains("\"text\""));
  CHECK_THAT(ErrorOf("<legend/>"), Contains("<entry>"));
  CHECK_THAT(ErrorOf("<trails duration='-1'/>"), Contains("\"duration\""));
  CHECK_THAT(ErrorOf("<trails duration='1e9'/>"), Contains("less than 4e9 ticks, got 1e+09"));
  CHECK_THAT(ErrorOf("<headings width='-2'/>"), Contains("\"width\""));
  CHECK_THAT(ErrorOf("<ids of=' '/>"), Contains("names no type"));
}

TEST_CASE("overlays: bar, axes and their marks have the scale of arenas of any shape",
          "[overlays]") {
  const bool isWide = GENERATE(false, true);
  CAPTURE(isWide);
  CTestWorld world(SExperiment{
      .Engines = "<kinematics2d id='e'/>", .ArenaSize = isWide ? "16,2,2" : "2,16,2", .Arena = ""});
  COverlaysOf axes(world, "<axes/>");
  // at most 8 numbers along 16 m: every 2 m; -8 ... 8 and 0 (-1 to 1 m), and two names
  CHECK(axes.DrawAll(EKind::Text).size() == 9 + 1 + 2);
  // marks of 1.5 % of the shorter side, after the line of the axis
  CHECK(axes.DrawAll(EKind::Line)[1].Size.Length() == Approx(0.03));
  COverlaysOf bar(world, "<scale_bar/>");
  const std::vector<SDrawnShape> lines = bar.DrawAll(EKind::Line);
  // outside of the corner, by a quarter of 5 % of the shorter side
  const CVector3 corner = isWide ? CVector3(-8.0, -1.0, 0.0) : CVector3(-1.0, -8.0, 0.0);
  CHECK(IsAt(lines[0].Position, corner + CVector3(0.0, -0.025, 0.0)));
  CHECK(lines[0].Size.Length() == Approx(isWide ? 2.0 : 0.5));
}

TEST_CASE("overlays: texts without a size have 12 pixels at least", "[overlays]") {
  CTestWorld world = MakeWorld();
  const CSimulator::CScope scope(world.GetSimulator());
  CConfigurationDocument document;
  document.Parse("<view><overlays><clock/></overlays></view>", "test.argos");
  CViewDrawing view;
  view.Init(document.GetRoot());
  view.Observe(world.GetSimulator());
  for (const auto& [height, size] :
       {std::pair(100U, 12.0), std::pair(480U, 12.0), std::pair(1000U, 25.0)}) {
    const CDrawing& drawing = view.Draw(world.GetSimulator(), 640, height);
    CHECK(drawing.GetStyles()[drawing.GetShapes()[0].Style].Size == Approx(size));
  }
}

TEST_CASE("overlays: an arrow without a length ends a radius in front of its robot", "[overlays]") {
  CTestWorld world = MakeWorld();
  COverlaysOf view(world, "<headings of='e-puck'/>");
  const std::vector<SDrawnShape> lines = view.DrawAll(EKind::Line);
  REQUIRE(lines.size() == 2);
  const SBoundingBox box = world.Get<CEPuckEntity>("right").GetEmbodiedEntity().GetBoundingBox();
  const CVector3 size = box.MaxCorner - box.MinCorner;
  // without its tip, which is 35 % of it
  CHECK(lines[0].Size.Length() == Approx(0.65 * std::max(size.GetX(), size.GetY())));
}

}  // namespace overlays_test
