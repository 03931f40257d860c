#include <argos3/core/simulator/visualization/view_drawing.h>

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/testing/support/experiment.h>

#include <catch2/catch.hpp>

#include <string>
#include <vector>

namespace view_drawing_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

std::vector<std::string> g_events;  // of all functions below, in order

class CNotedFunctions : public CDrawingFunctions {
 public:
  void Init(TConfigurationNode& node) override {
    GetNodeAttribute(node, "name", m_name);
    if (m_name == "bad") {
      THROW_ARGOSEXCEPTION("no such ink");
    }
  }
  void Reset() override { g_events.push_back("reset " + m_name); }
  void Destroy() override { g_events.push_back("destroy " + m_name); }
  void DrawInWorld() override { GetDrawing().DrawText(CVector3(), m_name); }

 private:
  std::string m_name;
};

class CDrawingLoopFunctions : public CLoopFunctions {
 public:
  void DrawInWorld(CDrawing& drawing) override { drawing.DrawText(CVector3(), "loop"); }
  void DrawInOverlay(CDrawing& drawing) override { drawing.DrawText(CVector3(), "overlay"); }
};

REGISTER_DRAWING_FUNCTIONS(CNotedFunctions, "noted_functions")
REGISTER_LOOP_FUNCTIONS(CDrawingLoopFunctions, "drawing_loop_functions")

// the element of a view, and what it draws
class CView {
 public:
  explicit CView(const std::string& children) {
    m_document.Parse("<view>\n" + children + "</view>", "test.argos");
    m_drawing.Init(m_document.GetRoot());
  }

  CViewDrawing& operator*() { return m_drawing; }

 private:
  CConfigurationDocument m_document;
  CViewDrawing m_drawing;
};

}  // namespace

TEST_CASE("view drawing: functions draw in the order of the file, loop functions last",
          "[core][drawing]") {
  CTestWorld world(
      SExperiment{.LoopFunctions = "<loop_functions label='drawing_loop_functions' />"});
  CView view(
      "<user_functions label='noted_functions' name='b' />"
      "<user_functions label='noted_functions' name='a' />");
  const CDrawing& drawing = (*view).Draw(world.GetSimulator(), 320, 240);
  CHECK(drawing.GetWidth() == 320);
  CHECK(drawing.GetTexts() == "baloopoverlay");
  CHECK(drawing.GetShapes().back().Space == SDrawnShape::ESpace::Overlay);
  // the list is cleared and filled for each frame
  CHECK((*view).Draw(world.GetSimulator(), 320, 240).GetShapes().size() == 4);
}

TEST_CASE("view drawing: nothing is drawn without functions", "[core][drawing]") {
  CTestWorld world{SExperiment()};
  CView view("");
  CHECK((*view).Draw(world.GetSimulator(), 64, 48).GetShapes().empty());
}

TEST_CASE("view drawing: functions are reset when the clock goes back, and destroyed in reverse",
          "[core][drawing]") {
  CTestWorld world{SExperiment()};
  CView view(
      "<user_functions label='noted_functions' name='a' />"
      "<user_functions label='noted_functions' name='b' />");
  g_events.clear();
  (*view).Draw(world.GetSimulator(), 64, 48);
  world.Step(3);
  (*view).Draw(world.GetSimulator(), 64, 48);
  CHECK(g_events.empty());
  world.GetSimulator().Reset();
  (*view).Draw(world.GetSimulator(), 64, 48);
  CHECK(g_events == std::vector<std::string>{"reset a", "reset b"});
  (*view).Destroy();
  CHECK(g_events == std::vector<std::string>{"reset a", "reset b", "destroy b", "destroy a"});
}

TEST_CASE("view drawing: errors give the place in the file", "[core][drawing]") {
  CHECK_THROWS_WITH(CView("<user_functions label='noted_function' />"),
                    Contains("test.argos:2: <user_functions label=\"noted_function\">") &&
                        Contains("there is no CDrawingFunctions") && Contains("noted_functions"));
  CHECK_THROWS_WITH(CView("<user_functions />"), Contains("test.argos:2") && Contains("\"label\""));
  CHECK_THROWS_WITH(CView("<user_functions label='x' library='/no/such/lib.so' />"),
                    Contains("test.argos:2") && Contains("/no/such/lib.so"));
  CHECK_THROWS_WITH(CView("<user_functions label='noted_functions' name='bad' />"),
                    Contains("test.argos:2") && Contains("no such ink"));
}

}  // namespace view_drawing_test
