// Faces and lines of users' OpenGL calls.

#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_obj_model.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_user_functions.h>
#include <argos3/testing/support/captured_logs.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <thread>
#include <vector>

using namespace argos;

namespace compat_gl_calls_test {

// Calls a function in the hook that draws in the world.
class CGlDrawing : public CQTOpenGLUserFunctions {
 public:
  explicit CGlDrawing(std::function<void()> f_draw) : m_fDraw(f_draw) {}
  using CQTOpenGLUserFunctions::DrawInWorld;
  void DrawInWorld() override { m_fDraw(); }

 private:
  std::function<void()> m_fDraw;
};

typedef std::array<CVector3, 3> TTriangle;

struct SPicture {
  std::vector<TTriangle> Triangles;
  std::vector<CColor> Colors;  // of the triangles
  std::vector<SDrawnShape> Others;
};

static SPicture Draw(const std::function<void()>& f_draw) {
  CGlDrawing functions(f_draw);
  CDrawing drawing;
  drawing.Begin(320, 240);
  functions.DrawAll(drawing, {});
  SPicture picture;
  for (const SDrawnShape& shape : drawing.GetShapes()) {
    if (!shape.IsFace) {
      picture.Others.push_back(shape);
      continue;
    }
    REQUIRE(shape.Count == 3);
    TTriangle& triangle = picture.Triangles.emplace_back();
    for (UInt32 i = 0; i < 3; ++i) {
      const CVector2& flat = drawing.GetCorners()[shape.First + i];
      triangle[i] = CVector3(flat.GetX(), flat.GetY(), 0.0).Rotate(shape.Orientation);
      triangle[i] += shape.Position;
    }
    picture.Colors.push_back(shape.Color);
  }
  return picture;
}

static void CheckTriangles(const SPicture& picture, const std::vector<TTriangle>& expected) {
  REQUIRE(picture.Triangles.size() == expected.size());
  for (size_t i = 0; i < expected.size(); ++i) {
    for (size_t corner = 0; corner < 3; ++corner) {
      CAPTURE(i, corner, picture.Triangles[i][corner], expected[i][corner]);
      CHECK(Distance(picture.Triangles[i][corner], expected[i][corner]) < 1e-9);
    }
  }
}

// half the vector product, towards the side from which the corners are counter-clockwise
static CVector3 AreaOf(const TTriangle& triangle) {
  CVector3 area = triangle[1] - triangle[0];
  return area.CrossProduct(triangle[2] - triangle[0]) * 0.5;
}

// the corners of a square of 2 m: what the shapes below are made of
static const CVector3 kCorner[] = {CVector3(0, 0, 0), CVector3(2, 0, 0), CVector3(2, 2, 0),
                                   CVector3(0, 2, 0)};

static void AddVertices(const std::vector<int>& vec_corners) {
  for (int i : vec_corners) {
    glVertex3d(kCorner[i].GetX(), kCorner[i].GetY(), kCorner[i].GetZ());
  }
}

TEST_CASE("compat: each kind of OpenGL's shapes is made of its triangles", "[compat]") {
  const TTriangle lower = {kCorner[0], kCorner[1], kCorner[2]};
  const TTriangle upper = {kCorner[0], kCorner[2], kCorner[3]};
  struct SCase {
    GLenum Shape;
    std::vector<int> Corners;
    std::vector<TTriangle> Expected;
  };
  const std::vector<SCase> cases = {
      {GL_TRIANGLES, {0, 1, 2, 0, 2, 3, 0}, {lower, upper}},
      {GL_TRIANGLE_FAN, {0, 1, 2, 3}, {lower, upper}},
      {GL_POLYGON, {0, 1, 2, 3}, {lower, upper}},
      {GL_QUADS, {0, 1, 2, 3, 0, 1, 2}, {lower, upper}},
      {GL_QUADS, {0, 1, 2, 3, 0, 1, 2, 3}, {lower, upper, lower, upper}},
      {GL_QUAD_STRIP, {0, 1, 3, 2}, {lower, upper}},
      {GL_TRIANGLE_STRIP,
       {0, 1, 3, 2},
       {{kCorner[0], kCorner[1], kCorner[3]}, {kCorner[3], kCorner[1], kCorner[2]}}},
      {GL_TRIANGLE_FAN, {0, 1}, {}},
      // without an area
      {GL_TRIANGLES, {0, 1, 1, 0, 1, 2}, {lower}},
      {GL_QUADS, {0, 1, 2, 2}, {lower}}};
  for (const SCase& one : cases) {
    CAPTURE(one.Shape, one.Corners);
    CheckTriangles(Draw([&one] {
                     glBegin(one.Shape);
                     AddVertices(one.Corners);
                     glEnd();
                   }),
                   one.Expected);
  }
}

TEST_CASE("compat: a cube of quads is closed, and in the frame of OpenGL calls", "[compat]") {
  // faces of the cube from 0 to 1, counter-clockwise seen from outside
  const GLfloat pfVertices[6][4][3] = {
      {{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}, {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
      {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}, {{0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}},
      {{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}};
  const SPicture picture = Draw([&pfVertices] {
    glTranslatef(1.0f, 2.0f, 3.0f);
    glScalef(2.0f, 3.0f, 4.0f);
    glRotatef(90.0f, 0.0f, 0.0f, 1.0f);
    glTranslatef(-1.0f, 0.0f, 0.0f);
    glBegin(GL_QUADS);
    for (const auto& face : pfVertices) {
      for (const GLfloat* pf_vertex : face) {
        glVertex3fv(pf_vertex);
      }
    }
    glEnd();
  });
  REQUIRE(picture.Triangles.size() == 12);
  CVector3 sum;
  Real volume = 0.0;
  Real area = 0.0;
  for (const TTriangle& triangle : picture.Triangles) {
    sum += AreaOf(triangle);
    area += AreaOf(triangle).Length();
    volume += AreaOf(triangle).DotProduct(triangle[0]) / 3.0;
    for (const CVector3& corner : triangle) {
      // x of the cube is y of the box, y is -x: (-1 to 0) turned is a box from (-1,-1) to (0,0)
      CHECK(std::fabs(std::fabs(corner.GetX() - 0.0) - 1.0) < 1e-9);
      CHECK(std::fabs(std::fabs(corner.GetY() - 0.5) - 1.5) < 1e-9);
      CHECK(std::fabs(std::fabs(corner.GetZ() - 5.0) - 2.0) < 1e-9);
    }
  }
  CHECK(sum.Length() < 1e-9);
  CHECK_THAT(area, Catch::WithinAbs(2.0 * (6.0 + 8.0 + 12.0), 1e-9));
  CHECK_THAT(volume, Catch::WithinAbs(24.0, 1e-9));
}

TEST_CASE("compat: the side of a cylinder is a strip of quads", "[compat]") {
  const int nVertices = 16;
  const SPicture picture = Draw([] {
    glBegin(GL_QUAD_STRIP);
    for (int i = 0; i <= nVertices; ++i) {
      const CRadians cAngle(CRadians::TWO_PI * static_cast<Real>(i) / nVertices);
      glNormal3d(Cos(cAngle), Sin(cAngle), 0.0);
      glVertex3d(0.5 * Cos(cAngle), 0.5 * Sin(cAngle), 0.2);
      glVertex3d(0.5 * Cos(cAngle), 0.5 * Sin(cAngle), 0.0);
    }
    glEnd();
  });
  REQUIRE(picture.Triangles.size() == 2 * nVertices);
  Real area = 0.0;
  for (const TTriangle& triangle : picture.Triangles) {
    area += AreaOf(triangle).Length();
    CHECK(std::fabs(AreaOf(triangle).GetZ()) < 1e-12);
  }
  CHECK_THAT(area, Catch::WithinAbs(0.2 * nVertices * std::sin(CRadians::PI.GetValue() / nVertices),
                                    1e-9));
}

TEST_CASE("compat: OpenGL's lines and points have colours and widths", "[compat]") {
  const SPicture picture = Draw([] {
    glColor3f(1.0f, 0.5f, 0.0f);
    glLineWidth(3.0f);
    glBegin(GL_LINES);
    AddVertices({0, 1, 2, 3, 0});
    glEnd();
    glColor4ub(1, 2, 3, 4);
    glBegin(GL_LINE_LOOP);
    AddVertices({0, 1, 2});
    glEnd();
    glPointSize(7.0f);
    glBegin(GL_POINTS);
    AddVertices({2});
    glEnd();
  });
  REQUIRE(picture.Others.size() == 2 + 3 + 1);
  CHECK(picture.Others[1].Position == kCorner[2]);
  CHECK(picture.Others[1].Size == CVector3(-2, 0, 0));
  CHECK(picture.Others[1].Color == CColor(255, 128, 0));
  CHECK(picture.Others[1].Pixels == 3.0);
  CHECK(picture.Others[4].Size == CVector3(-2, -2, 0));
  CHECK(picture.Others[4].Color == CColor(1, 2, 3));
  CHECK(picture.Others[5].Position == kCorner[2]);
  CHECK(picture.Others[5].Pixels == 7.0);
}

static void DrawTriangle(GLdouble f_z = 0.0) {
  glBegin(GL_TRIANGLES);
  glVertex3d(0.0, 0.0, f_z);
  glVertex3d(1.0, 0.0, f_z);
  glVertex3d(0.0, 1.0, f_z);
  glEnd();
}

TEST_CASE("compat: OpenGL's strips of lines are open, loops are closed", "[compat]") {
  const auto [shape, corners, lengths] =
      GENERATE(table<GLenum, std::vector<int>, std::vector<Real>>({
          {GL_LINE_STRIP, {0, 1, 2, 3}, {2, 2, 2}},
          {GL_LINE_LOOP, {0, 1, 2, 3}, {2, 2, 2, 2}},
          {GL_LINE_LOOP, {0, 1}, {2}},
          {GL_LINE_STRIP, {0}, {}},
      }));
  const SPicture picture = Draw([shape = shape, &corners = corners] {
    glBegin(shape);
    AddVertices(corners);
    glEnd();
  });
  REQUIRE(picture.Others.size() == lengths.size());
  for (size_t i = 0; i < lengths.size(); ++i) {
    CHECK(picture.Others[i].Size.Length() == lengths[i]);
  }
}

TEST_CASE("compat: OpenGL calls with values out of range have those of its ends, or no effect",
          "[compat]") {
  TakeLogErr();
  const SPicture picture = Draw([] {
    // more than can be kept, and as many of the other kind
    for (int i = 0; i < 1100; ++i) {
      glPushMatrix();
      glPushAttrib(GL_ALL_ATTRIB_BITS);
    }
    glTranslatef(0.0f, 0.0f, 7.0f);
    glColor3f(-1.0f, 2.0f, std::numeric_limits<GLfloat>::quiet_NaN());
    for (int i = 0; i < 1100 - 1024; ++i) {
      glPopMatrix();
    }
    DrawTriangle();
    for (int i = 0; i < 1024; ++i) {
      glPopMatrix();
    }
    // an axis without a length
    glRotatef(90.0f, 0.0f, 0.0f, 0.0f);
    DrawTriangle();
    // nothing was pushed
    glTranslatef(0.0f, 0.0f, 1.0f);
    glPopMatrix();
    DrawTriangle();
  });
  const auto triangle = [](Real z) {
    return TTriangle{CVector3(0, 0, z), CVector3(1, 0, z), CVector3(0, 1, z)};
  };
  CheckTriangles(picture, {triangle(7.0), triangle(0.0), triangle(1.0)});
  CHECK(picture.Colors[0] == CColor(0, 255, 0));
  CHECK_THAT(TakeLogErr(), Catch::Contains("by more than 1,024 times"));
}

TEST_CASE("compat: numbers of display lists end, and none are reserved for less than one",
          "[compat]") {
  CHECK(glGenLists(0) == 0);
  CHECK(glGenLists(-1) == 0);
  const GLuint unList = glGenLists(1);
  REQUIRE(unList != 0);
  glNewList(unList, GL_COMPILE);
  DrawTriangle();
  glEndList();
  glDeleteLists(unList, -1);
  CHECK(glIsList(unList));
  glDeleteLists(unList, 1);
  CHECK_FALSE(glIsList(unList));
  // calls outside of a shape
  CHECK(Draw([] { AddVertices({0, 1, 2}); }).Triangles.empty());
}

TEST_CASE("compat: triangles have the colour or the lit material that was set last", "[compat]") {
  const SPicture picture = Draw([] {
    const GLfloat pfGreen[] = {0.0f, 1.0f, 0.0f, 0.5f};
    const GLfloat pfBlack[] = {0.0f, 0.0f, 0.0f, 1.0f};
    DrawTriangle();
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, pfGreen);
    DrawTriangle();
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, pfGreen);
    DrawTriangle();
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, pfBlack);
    glNormal3f(0.0f, 0.0f, -1.0f);
    DrawTriangle();
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glEnable(GL_BLEND);
    glColor4f(1.0f, 0.0f, 0.0f, 0.5f);
    DrawTriangle();
    glPopAttrib();
    glDisable(GL_LIGHTING);
    DrawTriangle();
  });
  REQUIRE(picture.Colors.size() == 6);
  CHECK(picture.Colors[0].GetRed() == picture.Colors[0].GetBlue());
  CHECK(picture.Colors[1].GetGreen() > 200);
  CHECK(picture.Colors[1].GetRed() == 0);
  CHECK(picture.Colors[1].GetAlpha() == 255);
  // a light of its own
  CHECK(picture.Colors[2] == CColor(0, 255, 0));
  // a face that looks down is darker
  CHECK(picture.Colors[3].GetGreen() < 150);
  CHECK(picture.Colors[4] == CColor(255, 0, 0, 128));
  CHECK(picture.Colors[5] == CColor(255, 255, 255));
}

TEST_CASE("compat: display lists are drawn in the frame and colour of their calls", "[compat]") {
  const GLuint unLists = glGenLists(2);
  REQUIRE(unLists != 0);
  CHECK(glGenLists(1) == unLists + 2);
  // outside of hooks, as in constructors
  glNewList(unLists, GL_COMPILE);
  DrawTriangle();
  glTranslatef(0.0f, 0.0f, 1.0f);
  glEndList();
  glNewList(unLists + 1, GL_COMPILE);
  glCallList(unLists);
  glCallList(unLists);
  glEndList();
  const auto drawLists = [unLists] {
    glPushMatrix();
    glScaled(2.0, 2.0, 2.0);
    glColor3f(0.0f, 0.0f, 1.0f);
    glCallList(unLists + 1);
    glPopMatrix();
    DrawTriangle();
  };
  const TTriangle expected[] = {{CVector3(), CVector3(2, 0, 0), CVector3(0, 2, 0)},
                                {CVector3(0, 0, 2), CVector3(2, 0, 2), CVector3(0, 2, 2)},
                                {CVector3(), CVector3(1, 0, 0), CVector3(0, 1, 0)}};
  const SPicture picture = Draw(drawLists);
  CheckTriangles(picture, {expected[0], expected[1], expected[2]});
  CHECK(picture.Colors[1] == CColor::BLUE);
  // users keep the numbers in static objects, whatever simulation draws
  SPicture other;
  std::thread([&] { other = Draw(drawLists); }).join();
  CHECK(other.Triangles.size() == 3);
  // what is made in a hook, and replaced
  CHECK(Draw([unLists] {
          glNewList(unLists, GL_COMPILE_AND_EXECUTE);
          DrawTriangle();
          DrawTriangle();
          glEndList();
          glCallList(unLists + 1);
        }).Triangles.size() == 2 + 4);
  glDeleteLists(unLists, 2);
  CHECK_FALSE(glIsList(unLists));
  CHECK(Draw(drawLists).Triangles.size() == 1);
}

TEST_CASE("compat: matrices of OpenGL are multiplied, those of the camera stay", "[compat]") {
  const SPicture picture = Draw([] {
    glMatrixMode(GL_PROJECTION);
    glTranslatef(5.0f, 5.0f, 5.0f);
    glMatrixMode(GL_MODELVIEW);
    // x to z, y to x, z to y, and a move
    const GLfloat pfMatrix[] = {0, 0, 2, 0, 1, 0, 0, 0, 0, 1, 0, 0, 3, 4, 5, 1};
    glMultMatrixf(pfMatrix);
    DrawTriangle(1.0);
  });
  CheckTriangles(picture, {{CVector3(3, 5, 5), CVector3(3, 5, 7), CVector3(4, 5, 5)}});
}

static const std::string kThreeVertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nusemtl a\n";

TEST_CASE("compat: wrong lines of models are errors with their number", "[compat]") {
  const auto [line, message] = GENERATE(table<std::string, std::string>({
      {"f 1//1 2//1 0//1", "\"0\" is not a vertex from 1 to 3"},
      {"f 1//1 2//1 4//1", "\"4\" is not a vertex from 1 to 3"},
      {"f 1//1 2//1 -4//1", "\"-4\" is not a vertex from 1 to 3"},
      {"f 1//1 2//1 3x//1", "\"3x\" is not a vertex"},
      {"f 1//1 2//1 x//1", "\"x\" is not a vertex"},
      {"f 1//1 2//1 99999999999999999999//1", "is not a vertex"},
      {"f 1//1 2//1 3//2", "\"2\" is not a normal from 1 to 1"},
      {"v 1 2 3x", "\"3x\" is not a number"},
      {"v 1 2 inf", "\"inf\" is not a number"},
      {"v 1 2", "\"\" is not a number"},
  }));
  CHECK_THROWS_WITH(CQTOpenGLObjModel("", kThreeVertices + line),
                    Catch::Contains(":6: ") && Catch::Contains(message));
}

TEST_CASE("compat: faces of models count back from the last corner, and need an area", "[compat]") {
  const TTriangle triangle = {CVector3(), CVector3::X, CVector3::Y};
  CheckTriangles(Draw([] {
                   CQTOpenGLObjModel("", kThreeVertices +
                                             "f -3//-1 -2//1 -1//1\nf 1//1 2//1 2//1\n# f\n"
                                             "f 1//1 2//1 3//1 3//1\n")
                       .Draw();
                 }),
                 {triangle, triangle});
}

TEST_CASE("compat: materials of models have opacities from 0 to 1", "[compat]") {
  const auto [lines, alpha] = GENERATE(table<std::string, GLfloat>({
      {"d 0.75", 0.75f},
      {"Tr 0.25", 0.75f},
      {"d 2", 1.0f},
      {"Tr 3", 0.0f},
      {"Ka 0 0 0", 1.0f},
  }));
  CQTOpenGLObjModel cModel(
      "Kd 9 9 9\nnewmtl a\nKa 0.1 0.2 0.3\nKd 0.25 1 0.5\nKs 0.4 0.5 0.6\n" + lines,
      kThreeVertices + "f 1//1 2//1 3//1");
  CQTOpenGLObjModel::SMaterial& sMaterial = cModel.GetMaterial("a");
  CHECK(sMaterial.Alpha == alpha);
  CHECK(sMaterial.EnableTransparency == (alpha < 1.0f));
  CHECK(sMaterial.Diffuse == std::array<GLfloat, 4>{0.25f, 1.0f, 0.5f, alpha});
  CHECK(sMaterial.Specular == std::array<GLfloat, 4>{0.4f, 0.5f, 0.6f, alpha});
  CHECK((sMaterial.Ambient[1] == 0.2f) == (lines[0] != 'K'));
  // users' code may lower either of both
  const auto getAlpha = [&cModel] {
    return Draw([&cModel] { cModel.Draw(); }).Colors.at(0).GetAlpha();
  };
  CHECK(getAlpha() == std::lround(255.0 * alpha));
  sMaterial.EnableTransparency = true;
  sMaterial.Alpha = 0.2f;
  sMaterial.Diffuse[3] = 0.4f;
  CHECK(getAlpha() == 51);
  sMaterial.Alpha = 0.8f;
  CHECK(getAlpha() == 102);
}

TEST_CASE("compat: models can be in display lists", "[compat]") {
  const CQTOpenGLObjModel cModel("newmtl a\nKd 1 0 0\n",
                                 "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nusemtl a\nf 1//1 2//1 3//1");
  const GLuint unList = glGenLists(1);
  glNewList(unList, GL_COMPILE);
  glScalef(0.5f, 0.5f, 0.5f);
  cModel.Draw();
  glEndList();
  CheckTriangles(Draw([unList] { glCallList(unList); }),
                 {{CVector3(), CVector3(0.5, 0, 0), CVector3(0, 0.5, 0)}});
  glDeleteLists(unList, 1);
}

TEST_CASE("compat: OpenGL calls that end nothing leave nothing for the next entity", "[compat]") {
  TakeLogErr();
  const GLuint unList = glGenLists(1);
  for (int i = 0; i < 2; ++i) {
    CHECK(Draw([] {
            glPushMatrix();
            glScalef(3.0f, 3.0f, 3.0f);
            glColor3f(1.0f, 0.0f, 0.0f);
            glBegin(GL_TRIANGLES);
          }).Triangles.empty());
    Draw([unList] { glNewList(unList, GL_COMPILE); });
    const SPicture picture = Draw([] {
      AddVertices({0, 1, 2});
      glPopMatrix();
      DrawTriangle();
    });
    CheckTriangles(picture, {{CVector3(), CVector3::X, CVector3::Y}});
    CHECK(picture.Colors[0].GetRed() == picture.Colors[0].GetBlue());
  }
  const std::string warnings = TakeLogErr();
  for (const std::string text : {"glBegin() without glEnd()", "glNewList() without glEndList()"}) {
    CAPTURE(warnings);
    CHECK(warnings.find(text) != std::string::npos);
    CHECK(warnings.find(text) == warnings.rfind(text));
  }
}

TEST_CASE("compat: what OpenGL calls keep and repeat has limits", "[compat]") {
  TakeLogErr();
  const GLuint unList = glGenLists(1);
  glNewList(unList, GL_COMPILE);
  for (int i = 0; i < 1000100; ++i) {
    glTranslatef(0.0f, 0.0f, 0.0f);
  }
  glEndList();
  CHECK_THAT(TakeLogErr(), Catch::Contains("more than 1,000,000 calls"));
  // a list that calls itself twice
  glNewList(unList, GL_COMPILE);
  glCallList(unList);
  glCallList(unList);
  glEndList();
  Draw([unList] { glCallList(unList); });
  const std::string warnings = TakeLogErr();
  CHECK_THAT(warnings, Catch::Contains("64 deep") && Catch::Contains("10,000,000 calls"));
  glDeleteLists(unList, 1);
}

}  // namespace compat_gl_calls_test
