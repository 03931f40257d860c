// What users draw most, each as a class of its own: ids, trails, links, a path in the world, and
// text over the picture. Each must be seen in the frames, where it belongs.

#include "picture_difference.h"

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_user_functions.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/temporary_folder.h>

#include <QPainter>

#include <catch2/catch.hpp>

#include <map>
#include <string>
#include <vector>

namespace user_functions_test {

using namespace argos;

class CFiveIds : public CQTOpenGLUserFunctions {
 public:
  CFiveIds() { RegisterUserFunction<CFiveIds, CFootBotEntity>(&CFiveIds::Draw); }
  using CQTOpenGLUserFunctions::Draw;
  void Draw(CFootBotEntity& entity) {
    QFont cFont("Helvetica", 20);
    DrawText(CVector3(0.0, 0.0, 0.3), entity.GetId(), CColor::RED, cFont);
  }
};

class CFiveTrails : public CQTOpenGLUserFunctions {
 public:
  CFiveTrails() { RegisterUserFunction<CFiveTrails, CFootBotEntity>(&CFiveTrails::Remember); }
  void Remember(CFootBotEntity& entity) {
    m_tPlaces[entity.GetId()].push_back(entity.GetEmbodiedEntity().GetOriginAnchor().Position);
  }
  void DrawInWorld() override {
    for (TPlaces::iterator it = m_tPlaces.begin(); it != m_tPlaces.end(); ++it) {
      for (size_t i = 1; i < it->second.size(); ++i) {
        DrawRay(CRay3(it->second[i - 1], it->second[i]), CColor::RED, 4.0);
      }
    }
  }

 private:
  typedef std::map<std::string, std::vector<CVector3> > TPlaces;
  TPlaces m_tPlaces;
};

class CFiveLinks : public CQTOpenGLUserFunctions {
 public:
  void DrawInWorld() override {
    CSpace::TMapPerType& cRobots =
        CSimulator::GetInstance().GetSpace().GetEntitiesByType("foot-bot");
    std::vector<CVector3> vecPlaces;
    for (CSpace::TMapPerType::iterator it = cRobots.begin(); it != cRobots.end(); ++it) {
      CFootBotEntity& cRobot = *any_cast<CFootBotEntity*>(it->second);
      vecPlaces.push_back(cRobot.GetEmbodiedEntity().GetOriginAnchor().Position +
                          CVector3(0.0, 0.0, 0.3));
    }
    DrawRay(CRay3(vecPlaces.at(0), vecPlaces.at(1)), CColor::RED, 3.0);
  }
};

class CFivePath : public CQTOpenGLUserFunctions {
 public:
  void DrawInWorld() override {
    DrawCircle(CVector3(0.0, -0.8, 0.01), CQuaternion(), 0.2, CColor::RED, true, 30);
    DrawPoint(CVector3(0.5, -0.8, 0.01), CColor::RED, 8.0);
    DrawRay(CRay3(CVector3(0.0, -0.8, 0.01), CVector3(0.5, -0.8, 0.01)), CColor::RED, 3.0);
  }
};

class CFiveOverlay : public CQTOpenGLUserFunctions {
 public:
  void DrawOverlay(QPainter& painter) override {
    painter.setPen(QColor(255, 0, 0));
    painter.setFont(QFont("Helvetica", 18, QFont::Bold));
    painter.drawText(10, 25, "score 7");
  }
};

REGISTER_QTOPENGL_USER_FUNCTIONS(CFiveIds, "five_ids")
REGISTER_QTOPENGL_USER_FUNCTIONS(CFiveTrails, "five_trails")
REGISTER_QTOPENGL_USER_FUNCTIONS(CFiveLinks, "five_links")
REGISTER_QTOPENGL_USER_FUNCTIONS(CFivePath, "five_path")
REGISTER_QTOPENGL_USER_FUNCTIONS(CFiveOverlay, "five_overlay")

namespace {

// pixels of pure red: how many, and their middle as a share of the picture
struct SRed {
  size_t Count = 0;
  double X = 0.0;
  double Y = 0.0;
};

SRed FindRed(const SPicture& picture) {
  SRed red;
  const auto width = static_cast<size_t>(picture.Width);
  for (size_t i = 0; i + 3 < picture.Pixels.size(); i += 4) {
    if (picture.Pixels[i] > 220 && picture.Pixels[i + 1] < 50 && picture.Pixels[i + 2] < 50) {
      ++red.Count;
      red.X += (static_cast<double>(i / 4 % width) + 0.5) / picture.Width;
      red.Y += (static_cast<double>(i / 4 / width) + 0.5) / picture.Height;
    }
  }
  red.X /= static_cast<double>(red.Count);
  red.Y /= static_cast<double>(red.Count);
  return red;
}

// Two robots drive 0.2 m along x, to (-0.3, 0.5) and (0.7, 0.5); the last frame shows 2 m x 2 m
// from above, +x to the right.
SRed DrawWith(const std::string& label) {
  const CTemporaryFolder folder;
  const std::string script =
      folder.Write("drive.lua",
                   "function init() robot.wheels.set_velocity(20, 20) end "
                   "function step() end function reset() end function destroy() end");
  const std::string robot = "<controller config='drive'/></foot-bot>";
  SExperiment experiment;
  experiment.Length = 1.0;
  experiment.Controllers =
      "<lua_controller id='drive'><actuators><differential_steering implementation='default'/>"
      "</actuators><sensors/><params script='" +
      script + "'/></lua_controller>";
  experiment.LoopFunctions = "";
  experiment.Engines = "<dynamics2d id='dyn2d'/>";
  experiment.Arena = "<foot-bot id='one'><body position='-0.5,0.5,0'/>" + robot +
                     "<foot-bot id='two'><body position='0.5,0.5,0'/>" + robot;
  std::string xml = experiment.ToXml();
  xml.insert(xml.find("</argos-configuration>"),
             "<visualization><offscreen size='240x240' directory='" + folder.GetPath() +
                 "'><camera><placements><placement index='0' position='0,0,3' look_at='0,0,0' "
                 "up='0,1,0' orthographic_height='2'/></placements></camera>" +
                 (label.empty() ? "" : "<user_functions label='" + label + "'/>") +
                 "</offscreen></visualization>");
  CConfigurationDocument document;
  document.Parse(xml);
  CSimulator simulator;
  const CSimulator::CScope scope(simulator);
  simulator.Load(document);
  simulator.Execute();
  const SPicture picture = ReadPicture(folder.Path("frame_0000000010.png"));
  return FindRed(picture);
}

}  // namespace

TEST_CASE("user functions: ids, trails, links, paths and texts are in the frames at their places",
          "[golden][drawing]") {
  struct SExpected {
    std::string Label;
    size_t Least;  // pixels
    size_t Most;
    double X;  // of the middle, as a share of the picture
    double Y;
  };
  CHECK(DrawWith("").Count == 0);
  const SExpected expected = GENERATE(
      // the base lines begin at the robots
      SExpected{"five_ids", 40, 1200, 0.68, 0.23},
      // what the robots do not hide of 0.2 m, 4 pixels wide: 24 pixels, twice
      SExpected{"five_trails", 80, 240, 0.54, 0.25},
      // 1 m, 3 pixels wide
      SExpected{"five_links", 200, 480, 0.6, 0.25},
      // a disc of 24 pixels radius, a line outside of it, and a point
      SExpected{"five_path", 1700, 2300, 0.52, 0.9},
      SExpected{"five_overlay", 60, 1200, 0.2, 0.08});
  CAPTURE(expected.Label);
  const SRed red = DrawWith(expected.Label);
  CHECK(red.Count >= expected.Least);
  CHECK(red.Count <= expected.Most);
  CHECK(red.X == Approx(expected.X).margin(0.06));
  CHECK(red.Y == Approx(expected.Y).margin(0.04));
}

}  // namespace user_functions_test
