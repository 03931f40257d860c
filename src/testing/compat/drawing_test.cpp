// Drawing functions in code of users.

#include "user_drawing.h"

#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_obj_model.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/temporary_folder.h>

#include <QAbstractItemModel>
#include <QElapsedTimer>
#include <QOpenGLTexture>
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

namespace compat_drawing_test {

typedef std::vector<std::string> TEvents;

static SExperiment MakeExperiment() {
  return SExperiment{.Length = 0.3,
                     .Controllers =
                         "<toy_controller id='idle'><actuators /><sensors />"
                         "<params /></toy_controller>",
                     .LoopFunctions = "",
                     .Engines = "<dynamics2d id='dyn2d' />",
                     .Arena =
                         "<floor id='floor' source='loop_functions' pixels_per_meter='10' />"
                         "<foot-bot id='fb1'><body position='1,2,0' orientation='90,0,0' />"
                         "<controller config='idle' /></foot-bot>"
                         "<foot-bot id='fb0'><body position='-1,0,0' orientation='0,0,0' />"
                         "<controller config='idle' /></foot-bot>"};
}

TEST_CASE("compat: user functions draw all shapes, in the frames of ARGoS 3", "[compat]") {
  CTestWorld world(MakeExperiment());
  const CSimulator::CScope scope(world.GetSimulator());
  CUserDrawing functions;
  CDrawing drawing;
  drawing.Begin(320, 240);
  functions.DrawAll(drawing, world.GetSpace().GetRootEntityVector());
  CHECK(functions.m_vecEvents == TEvents{"floor floor"});
  typedef SDrawnShape::EKind EKind;
  std::vector<EKind> kinds;
  for (const SDrawnShape& shape : drawing.GetShapes()) {
    kinds.push_back(shape.Kind);
  }
  CHECK(kinds == std::vector<EKind>{EKind::Point, EKind::Text, EKind::Text, EKind::Text,
                                    EKind::Text, EKind::Point, EKind::Polygon, EKind::Polygon,
                                    EKind::Polygon, EKind::Polygon, EKind::Circle, EKind::Circle,
                                    EKind::Cylinder, EKind::Cylinder, EKind::Box, EKind::Box,
                                    EKind::Line, EKind::Line, EKind::Text});
  const std::vector<SDrawnShape>& shapes = drawing.GetShapes();
  CHECK(drawing.GetText(shapes[1]) == "fb1");
  CHECK(drawing.GetText(shapes[3]) == "fb0");
  // 2e-6 m: views round poses to 2^-20
  CHECK(Distance(shapes[1].Position, CVector3(1.0, 2.0, 0.3)) < 2e-6);
  CHECK(Distance(shapes[3].Position, CVector3(-1.0, 0.0, 0.3)) < 2e-6);
  const STextStyle& style = drawing.GetStyles()[shapes[2].Style];
  CHECK(style.Family == "Helvetica");
  CHECK(style.Size == 24.0);
  CHECK(style.IsBold);
  CHECK(shapes[2].Color == CColor::RED);
  // defaults
  CHECK(shapes[1].Color == CColor::BLACK);
  CHECK(shapes[10].Color == CColor::RED);
  CHECK(shapes[10].Count == 0);
  CHECK(shapes[11].Count == 5);
  CHECK_FALSE(shapes[11].IsFilled);
  CHECK(shapes[16].Pixels == 1.0);
  CHECK(shapes[17].Pixels == 3.0);
  // the overlay
  CHECK(shapes[18].Space == SDrawnShape::ESpace::Overlay);
  CHECK(shapes[18].Position == CVector3(5.0, 235.0, 0.0));
  CHECK(shapes[18].Color == CColor(10, 20, 30));
}

TEST_CASE("compat: hooks of keys, of the mouse and of the selection are called", "[compat]") {
  CTestWorld world(MakeExperiment());
  const CSimulator::CScope scope(world.GetSimulator());
  CUserDrawing functions;
  CEntity& robot = world.GetSpace().GetEntity("fb0");
  CEntity& floor = world.GetSpace().GetEntity("floor");
  CHECK(functions.GetSelectedEntity() == NULL);
  functions.SelectEntity(robot);
  CHECK(functions.GetSelectedEntity() == &robot);
  functions.SelectEntity(robot);
  functions.SelectEntity(floor);
  functions.DeselectEntity();
  functions.DeselectEntity();
  CHECK(functions.GetSelectedEntity() == NULL);
  QMouseEvent mouse(3, 4, Qt::LeftButton);
  functions.MouseKeyPressed(&mouse);
  functions.MouseMoved(&mouse);
  functions.MouseKeyReleased(&mouse);
  CHECK(functions.m_vecEvents == TEvents{"selected fb0", "deselected fb0", "selected floor (other)",
                                         "deselected floor", "left", "mouse at 7"});
  QKeyEvent key(Qt::Key_W, "w");
  functions.KeyPressed(&key);
  CHECK(functions.m_punKeys[0] == 1);
  functions.KeyReleased(&key);
  CHECK(functions.m_punKeys[0] == 0);
  QKeyEvent other(Qt::Key_Escape);
  functions.KeyPressed(&other);
  functions.KeyReleased(&other);
  functions.EntityMoved(robot, CVector3(), CVector3());
  functions.EntityRotated(robot, CQuaternion(), CQuaternion());
  CHECK(&functions.GetMainWindow().GetOpenGLWidget() == &functions.GetQTOpenGLWidget());
  CQTOpenGLMainWindow window(functions);
  functions.SetMainWindow(window);
  CHECK(&functions.GetQTOpenGLWidget() == &window.GetOpenGLWidget());
}

TEST_CASE("compat: user functions draw into the frames of qt-opengl and of offscreen", "[compat]") {
  const CTemporaryFolder folder;
  const std::string functions = "<user_functions label='user_drawing' title='x' />";
  const std::string views[] = {"<qt-opengl>" + functions + "<frame_grabbing directory='" +
                                   folder.GetPath() +
                                   "' base_name='qt_' headless_frame_size='64x48' /></qt-opengl>",
                               "<offscreen directory='" + folder.GetPath() +
                                   "' base_name='os_' size='64x48'>" + functions + "</offscreen>"};
  std::string xml = MakeExperiment().ToXml();
  const size_t end = xml.find("</argos-configuration>");
  REQUIRE(end != std::string::npos);
  for (const std::string& view : views) {
    CConfigurationDocument document;
    std::string withView = xml;
    document.Parse(withView.insert(end, "<visualization>" + view + "</visualization>"));
    CSimulator simulator;
    const CSimulator::CScope scope(simulator);
    simulator.Load(document);
    simulator.Execute();
  }
  CHECK(std::filesystem::exists(folder.Path("qt_0000000003.png")));
  CHECK(std::filesystem::exists(folder.Path("os_0000000003.png")));
}

TEST_CASE("compat: QFont, QString and QColor have what users call", "[compat]") {
  QFont font;
  CHECK(font.pointSize() == 12);
  CHECK(font.pixelSize() == 16);
  CHECK_FALSE(font.bold());
  font.setFamily("Times");
  font.setPixelSize(20);
  font.setBold(true);
  font.setItalic(true);
  CHECK(font.family() == "Times");
  CHECK(font.pointSize() == 15);
  CHECK(font.weight() == QFont::Bold);
  CHECK(font.italic());
  font.setWeight(QFont::Light);
  CHECK_FALSE(font.bold());
  QFont hinted;
  hinted.setStyleHint(QFont::Monospace);
  CHECK(hinted.family() == "monospace");
  CHECK(QString::number(12) == "12");
  CHECK(QString::number(1.5) == "1.5");
  CHECK(QString::number(2.0) == "2");
  CHECK(QString::number(2.0, 'f', 2) == "2.00");
  CHECK(QString::number(1234.5, 'e', 1) == "1.2e+03");
  CHECK(QString("%2 of %1, %1%, %10").arg(7).arg("a") == "a of 7, 7%, %10");
  CHECK(QColor(Qt::red).red() == 255);
  CHECK(QColor(Qt::darkGreen).green() == 128);
  CHECK(QColor(1, 2, 3).alpha() == 255);
}

// As in ARGoS 3, code of a window may have a model of what it shows.
class CItems : public QAbstractItemModel {
  Q_OBJECT

 public:
  QVariant data(const QModelIndex& c_index, int n_role) const override {
    return c_index.isValid() && n_role == Qt::DisplayRole ? QVariant("item") : QVariant();
  }
  int rowCount(const QModelIndex& /*c_parent*/) const override { return 2; }
  int columnCount(const QModelIndex& /*c_parent*/) const override { return 1; }
  QModelIndex index(int n_row, int n_column, const QModelIndex& c_parent) const override {
    return hasIndex(n_row, n_column, c_parent) ? createIndex(n_row, n_column) : QModelIndex();
  }
  QModelIndex parent(const QModelIndex& /*c_index*/) const override { return QModelIndex(); }
  Qt::ItemFlags flags(const QModelIndex& c_index) const override {
    return QAbstractItemModel::flags(c_index) | Qt::ItemIsEditable;
  }

 public slots:
  void Refresh() { emit dataChanged(QModelIndex(), QModelIndex()); }
};

TEST_CASE("compat: models of items have what users override", "[compat]") {
  CItems cItems;
  CHECK_THAT(TakeLogErr(), Catch::Contains("QAbstractItemModel"));
  cItems.Refresh();
  CHECK(cItems.data(cItems.index(1, 0, QModelIndex()), Qt::DisplayRole).toString() == "item");
  CHECK_FALSE(cItems.index(2, 0, QModelIndex()).isValid());
  CHECK(cItems.flags(QModelIndex()) == Qt::ItemIsEditable);
}

TEST_CASE("compat: the named colours are those of Qt", "[compat]") {
  // Qt's documentation of Qt::GlobalColor
  const std::vector<std::pair<Qt::GlobalColor, UInt32>> colors = {
      {Qt::black, 0x000000},       {Qt::white, 0xffffff},     {Qt::darkGray, 0x808080},
      {Qt::gray, 0xa0a0a4},        {Qt::lightGray, 0xc0c0c0}, {Qt::red, 0xff0000},
      {Qt::green, 0x00ff00},       {Qt::blue, 0x0000ff},      {Qt::cyan, 0x00ffff},
      {Qt::magenta, 0xff00ff},     {Qt::yellow, 0xffff00},    {Qt::darkRed, 0x800000},
      {Qt::darkGreen, 0x008000},   {Qt::darkBlue, 0x000080},  {Qt::darkCyan, 0x008080},
      {Qt::darkMagenta, 0x800080}, {Qt::darkYellow, 0x808000}};
  for (const auto& [name, rgb] : colors) {
    const QColor color(name);
    CAPTURE(static_cast<int>(name));
    CHECK(color.red() == static_cast<int>(rgb >> 16));
    CHECK(color.green() == static_cast<int>(rgb >> 8 & 0xff));
    CHECK(color.blue() == static_cast<int>(rgb & 0xff));
    CHECK(color.alpha() == 255);
  }
}

// Calls of third-party robots' drawing operations, as user functions can make them.
class CWidgetDrawing : public CQTOpenGLUserFunctions {
 public:
  CWidgetDrawing() { RegisterUserFunction<CWidgetDrawing, CFootBotEntity>(&CWidgetDrawing::Draw); }
  using CQTOpenGLUserFunctions::Draw;
  void Draw(CFootBotEntity& c_entity) {
    CQTOpenGLWidget& cWidget = GetQTOpenGLWidget();
    cWidget.DrawRays(c_entity.GetControllableEntity());
    cWidget.DrawBoundingBox(c_entity.GetEmbodiedEntity());
    cWidget.DrawEntity(c_entity.GetEmbodiedEntity());
    DrawPoint(CVector3(0.5, 0.0, 0.0));
  }
};

TEST_CASE("compat: the widget draws rays, bounding boxes and frames of entities", "[compat]") {
  CTestWorld world(MakeExperiment());
  const CSimulator::CScope scope(world.GetSimulator());
  auto& robot = world.Get<CFootBotEntity>("fb1");
  robot.GetControllableEntity().AddCheckedRay(true, CRay3(CVector3(1, 2, 3), CVector3(4, 5, 6)));
  CWidgetDrawing functions;
  CDrawing drawing;
  drawing.Begin(320, 240);
  functions.DrawAll(drawing, {&robot});
  const std::vector<SDrawnShape>& shapes = drawing.GetShapes();
  REQUIRE(shapes.size() == 1 + 12 + 1);
  CHECK(shapes[0].Color == CColor::MAGENTA);
  CHECK(Distance(shapes[0].Position, CVector3(1, 2, 3)) < 2e-6);
  CHECK(Distance(shapes[0].Size, CVector3(3, 3, 3)) < 2e-6);
  const SBoundingBox& box = robot.GetEmbodiedEntity().GetBoundingBox();
  Real length = 0.0;
  for (size_t i = 1; i < 13; ++i) {
    CHECK(shapes[i].Kind == SDrawnShape::EKind::Line);
    CHECK(shapes[i].Color == CColor::WHITE);
    CHECK(shapes[i].Pixels == 3.0);
    length += shapes[i].Size.Length();
  }
  const CVector3 extents = box.MaxCorner - box.MinCorner;
  CHECK_THAT(length,
             Catch::WithinAbs(4.0 * (extents.GetX() + extents.GetY() + extents.GetZ()), 1e-4));
  // fb1 looks along y
  CHECK(Distance(shapes[13].Position, CVector3(1.0, 2.5, 0.0)) < 2e-6);
}

// a square of 2 m, upright at x = 1, in two materials
constexpr const char* kMaterials =
    "newmtl red\nKd 1 0 0\n\n# glass\nnewmtl glass\nKd 0 0 1\nd 0.5\nmap_Kd x.png\n";
constexpr const char* kSquare =
    "mtllib other.mtl\nv 1 -1 0\nv 1 1 0\nv +1 1 2\r\nv 1 -1 2e0\nvn -1 0 0\nvn 1 0 0\n"
    "usemtl red\nf 1//2 2//2 3//2 4//2\nusemtl glass\nf -4/1/1 -3/1/1 -2/1/1\nusemtl none\n"
    "f 1 2 3\n";

class CModelDrawing : public CQTOpenGLUserFunctions {
 public:
  CQTOpenGLObjModel Model{kMaterials, kSquare};
  bool IsMoved = false;

  void DrawInWorld() override {
    glPushMatrix();
    if (IsMoved) {
      glTranslatef(0.0f, 0.0f, 1.0f);
      glRotated(90.0, 0.0, 0.0, 2.0);
    }
    glNewList(1, GL_COMPILE);
    glTranslated(7.0, 0.0, 0.0);
    Model.Draw();
    glEndList();
    Model.Draw();
    glPopMatrix();
    DrawPoint(CVector3());
  }
};

static std::vector<CVector3> CornersOf(const CDrawing& drawing, const SDrawnShape& shape) {
  std::vector<CVector3> corners;
  for (UInt32 i = 0; i < shape.Count; ++i) {
    const CVector2& flat = drawing.GetCorners()[shape.First + i];
    CVector3 corner(flat.GetX(), flat.GetY(), 0.0);
    corners.push_back(corner.Rotate(shape.Orientation) + shape.Position);
  }
  return corners;
}

TEST_CASE("compat: models are drawn with their materials, in the frame of OpenGL calls",
          "[compat]") {
  CModelDrawing functions;
  functions.Model.Draw();
  CDrawing drawing;
  drawing.Begin(320, 240);
  functions.DrawAll(drawing, {});
  // a fan of two triangles, and one in each of two other materials
  REQUIRE(drawing.GetShapes().size() == 2 + 1 + 1 + 1);
  const SDrawnShape& second = drawing.GetShapes()[1];
  CHECK(second.IsFace);
  CHECK(second.Color.GetRed() > 0);
  CHECK(second.Color.GetGreen() == 0);
  const std::vector<CVector3> corners = CornersOf(drawing, second);
  const std::vector<CVector3> expected = {CVector3(1, -1, 0), CVector3(1, 1, 2),
                                          CVector3(1, -1, 2)};
  for (size_t i = 0; i < 3; ++i) {
    CHECK(Distance(corners[i], expected[i]) < 1e-12);
  }
  CHECK(drawing.GetShapes()[2].Color.GetAlpha() == 128);
  // a name without a material is grey
  CHECK(drawing.GetShapes()[3].Color.GetRed() == drawing.GetShapes()[3].Color.GetBlue());
  functions.IsMoved = true;
  functions.Model.GetMaterial("red").Emission = {{0.0f, 1.0f, 0.0f, 1.0f}};
  drawing.Begin(320, 240);
  functions.DrawAll(drawing, {});
  CHECK(drawing.GetShapes()[1].Color.GetGreen() == 255);
  CHECK(Distance(CornersOf(drawing, drawing.GetShapes()[1])[0], CVector3(1, 1, 1)) < 1e-12);
  CHECK(drawing.GetShapes()[4].Position == CVector3());
}

TEST_CASE("compat: errors of models have file and line", "[compat]") {
  using Catch::Contains;
  CQTOpenGLObjModel cModel(kMaterials, kSquare);
  CHECK_THROWS_WITH(cModel.GetMaterial("led"), Contains("\"led\"; it has: glass, red"));
  CHECK_THROWS_WITH(CQTOpenGLObjModel("", "v 1 2 3\n"), Contains("no normals"));
  CHECK_THROWS_WITH(CQTOpenGLObjModel("", "v 1 2 3\nv 1 two 3\n"),
                    Contains("(text of a model):2: \"two\" is not a number"));
  CHECK_THROWS_WITH(CQTOpenGLObjModel("", "v 0 0 0\nv 1 0 0\nf 1 2 3\n"),
                    Contains(":3: \"3\" is not a vertex from 1 to 2"));
  CHECK_THROWS_WITH(CQTOpenGLObjModel("", "v 0 0 0\nf 1 1\n"), Contains("three corners"));
  CHECK_THROWS_WITH(CQTOpenGLObjModel("newmtl a\nnewmtl a\n", ""), Contains("defined twice"));
  CHECK_THROWS_WITH(CQTOpenGLObjModel("none.obj"),
                    Contains("qt-opengl/models/none.obj") && Contains("working directory"));
  const CTemporaryFolder folder;
  std::ofstream(folder.Path("cube.obj")) << "mtllib cube.mtl\n";
  CHECK_THROWS_WITH(CQTOpenGLObjModel(folder.Path("cube.obj")),
                    Contains("cube.mtl\" cannot be read"));
  std::ofstream(folder.Path("cube.mtl")) << kMaterials;
  std::ofstream(folder.Path("cube.obj")) << "mtllib cube.mtl\nvn 0 0 1\n";
  CHECK_NOTHROW(CQTOpenGLObjModel(folder.Path("cube.obj")).GetMaterial("red"));
}

TEST_CASE("compat: what needs a window is accepted and named once", "[compat]") {
  TakeLogErr();
  WarnOfQtName("QTheName");
  WarnOfQtName("QTheName");
  const std::string warning = TakeLogErr();
  CHECK_THAT(warning, Catch::Contains("QTheName is accepted, but has no effect"));
  CHECK(warning.find("QTheName") == warning.rfind("QTheName"));
  QFont cFont("Helvetica", 12);
  cFont.setCapitalization(QFont::AllUppercase);
  CHECK(cFont.capitalization() == QFont::AllUppercase);
  QElapsedTimer cTimer;
  cTimer.start();
  CHECK(cTimer.elapsed() >= 0);
}

}  // namespace compat_drawing_test
