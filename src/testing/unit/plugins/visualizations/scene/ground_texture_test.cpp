#include <argos3/plugins/simulator/visualizations/offscreen/renderer.h>
#include <argos3/plugins/simulator/visualizations/scene/ground_texture.h>
#include <argos3/testing/support/pictures.h>
#include <argos3/testing/support/temporary_folder.h>

#include <catch2/catch.hpp>

#include <string>

namespace ground_texture_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

class CTemporaryFile {
 public:
  CTemporaryFile(const std::string& name, const std::string& content)
      : m_path(m_folder.Write(name, content)) {}
  const std::string& GetPath() const { return m_path; }

 private:
  CTemporaryFolder m_folder;
  std::string m_path;
};

SFloorImage Read(const std::string& attributes) {
  CConfigurationDocument document;
  document.Parse("<offscreen " + attributes + " />", "test.argos");
  return ReadGroundTexture(document.GetRoot());
}

std::string Texture(const std::string& path, const std::string& more = "") {
  return "ground_texture='" + path + "' " + more;
}

// a binary PPM of 2 x 1 pixels: red, green
const std::string kRedGreen = std::string("P6\n2 1\n255\n") + "\xf0\x10\x10\x10\xf0\x10";

}  // namespace

TEST_CASE("ground texture: none without the attribute", "[visualizations][offscreen][xml]") {
  CHECK(Read("").Pixels == nullptr);
}

TEST_CASE("ground texture: is repeated over the arena, with square pixels",
          "[visualizations][offscreen]") {
  const CTemporaryFile file("tiles.ppm", kRedGreen);
  SScene scene = MakeEmptyScene();  // from -2 to 2 m
  scene.ShowGrid = false;
  scene.Floor = Read(Texture(file.GetPath(), "ground_texture_size='2'"));
  CHECK(scene.Floor.Width == 2);
  CHECK(scene.Floor.Height == 1);
  CHECK(scene.Floor.TileSize[0] == 2.0f);
  CHECK(scene.Floor.TileSize[1] == 1.0f);
  CRenderer renderer(SmallPicture());
  SPicture picture;
  const SCameraPlacement above = ViewFromAbove(6.0);
  renderer.Render(scene, above, picture);
  for (const double y : {-1.5, -0.5, 0.5, 1.5}) {
    for (const double x : {-1.5, 0.5}) {
      CAPTURE(x, y);
      CHECK(IsReddish(PixelOf(picture, above, Eigen::Vector3d(x, y, 0.0))));
      CHECK(IsGreenish(PixelOf(picture, above, Eigen::Vector3d(x + 1.0, y, 0.0))));
    }
  }
}

TEST_CASE("ground texture: covers the arena once without a size", "[visualizations][offscreen]") {
  const CTemporaryFile file("tiles.ppm", kRedGreen);
  SScene scene = MakeEmptyScene();
  scene.ShowGrid = false;
  scene.Floor = Read(Texture(file.GetPath()));
  CRenderer renderer(SmallPicture());
  SPicture picture;
  const SCameraPlacement above = ViewFromAbove(6.0);
  renderer.Render(scene, above, picture);
  for (const double y : {-1.5, 0.0, 1.5}) {
    CHECK(IsReddish(PixelOf(picture, above, Eigen::Vector3d(-1.5, y, 0.0))));
    CHECK(IsGreenish(PixelOf(picture, above, Eigen::Vector3d(1.5, y, 0.0))));
  }
}

TEST_CASE("ground texture: what is no image, or no size, is an error with file and line",
          "[visualizations][offscreen][xml]") {
  const CTemporaryFile text("text.png", "no image");
  const CTemporaryFile cut("cut.png", "\x89PNG\r\n\x1a\n");
  CHECK_THROWS_WITH(Read(Texture("/no/such.png")),
                    Contains("test.argos:1: <offscreen>: attribute \"ground_texture\"") &&
                        Contains("there is no texture \"/no/such.png\"; looked for"));
  CHECK_THROWS_WITH(Read(Texture(text.GetPath())), Contains("the texture \"" + text.GetPath()));
  CHECK_THROWS_WITH(Read(Texture(cut.GetPath())), Contains("the texture \"" + cut.GetPath()));
  const CTemporaryFile good("tiles.ppm", kRedGreen);
  for (const char* const size : {"0", "-1", "nan", "inf"}) {
    CHECK_THROWS_WITH(
        Read(Texture(good.GetPath(), "ground_texture_size='" + std::string(size) + "'")),
        Contains("test.argos:1"));
  }
  CHECK_THROWS_WITH(Read("ground_texture_size='1'"), Contains("without \"ground_texture\""));
}

}  // namespace ground_texture_test
