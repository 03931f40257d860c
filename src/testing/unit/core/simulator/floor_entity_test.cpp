#include <argos3/core/simulator/entity/floor_entity.h>

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>

#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

using namespace argos;
using Catch::Contains;

namespace {

// black on the left half of the world, white on the right
class CFloorTestLoopFunctions : public CLoopFunctions {
 public:
  CColor GetFloorColor(const CVector2& positionOnFloor) override {
    return positionOnFloor.GetX() < 0.0 ? CColor::BLACK : CColor::WHITE;
  }
};
REGISTER_LOOP_FUNCTIONS(CFloorTestLoopFunctions, "floor_test_loop_functions")

// a folder that goes away with its content
class CFolder {
 public:
  CFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "floor_test_XXXXXX").string();
    REQUIRE(mkdtemp(pattern.data()) != nullptr);
    m_path = pattern;
  }
  ~CFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
  }
  std::string File(const std::string& name) const { return (m_path / name).string(); }
  std::string Path() const { return m_path.string(); }

 private:
  std::filesystem::path m_path;
};

// 4 x 2 pixels. In the file, the upper row comes first.
void WriteImage(const std::string& path) {
  std::ofstream(path) << "P3 4 2 255\n"
                         "255 0 0   0 255 0   0 0 255   255 255 255\n"
                         "10 20 30  40 50 60  70 80 90  100 110 120\n";
}

// an arena 4 m x 2 m around (10, 20): each pixel is a square metre
class CWorld {
 public:
  explicit CWorld(const std::string& floor, const std::string& more = "") : m_scope(m_simulator) {
    m_document.Parse(
        "<argos-configuration>\n"
        "<framework><experiment ticks_per_second=\"10\" length=\"1\" "
        "random_seed=\"1\"/></framework>\n"
        "<controllers/><physics_engines/><media/>" +
            more + "<arena size=\"4,2,1\" center=\"10,20,0\">\n" + floor +
            "\n</arena></argos-configuration>",
        "floor.argos");
    m_simulator.Load(m_document);
  }
  CSpace& Space() { return m_simulator.GetSpace(); }
  CFloorEntity& Floor() { return Space().GetFloorEntity(); }

 private:
  CConfigurationDocument m_document;
  CSimulator m_simulator;
  CSimulator::CScope m_scope;
};

std::string ImageFloor(const std::string& path) {
  return "<floor id=\"f\" source=\"image\" path=\"" + path + "\"/>";
}

std::string ErrorOf(const std::string& floor) {
  try {
    CWorld world(floor);
  } catch (const CARGoSException& ex) {
    return ex.what();
  }
  return "";
}

}  // namespace

TEST_CASE("floor: an image is stretched over the arena, its lowest row at the smallest y",
          "[core][floor]") {
  const CFolder folder;
  WriteImage(folder.File("image.ppm"));
  CWorld world(ImageFloor(folder.File("image.ppm")));
  CFloorEntity& floor = world.Floor();
  CHECK(floor.GetColorSource() == CFloorEntity::FROM_IMAGE);
  CHECK(floor.GetPixelsPerMeter() == 1);
  CHECK(floor.GetColorAtPoint(8.5, 19.5) == CColor(10, 20, 30));
  CHECK(floor.GetColorAtPoint(11.5, 19.5) == CColor(100, 110, 120));
  CHECK(floor.GetColorAtPoint(8.5, 20.5) == CColor::RED);
  CHECK(floor.GetColorAtPoint(9.5, 20.5) == CColor::GREEN);
  CHECK(floor.GetColorAtPoint(10.5, 20.5) == CColor::BLUE);
  // the border between two pixels belongs to the upper one
  CHECK(floor.GetColorAtPoint(10.0, 20.0) == CColor::BLUE);
}

TEST_CASE("floor: outside the arena the colour of the nearest edge holds", "[core][floor]") {
  const CFolder folder;
  WriteImage(folder.File("image.ppm"));
  CWorld world(ImageFloor(folder.File("image.ppm")));
  CFloorEntity& floor = world.Floor();
  CHECK(floor.GetColorAtPoint(12.0, 21.0) == CColor::WHITE);
  CHECK(floor.GetColorAtPoint(1e300, 1e300) == CColor::WHITE);
  CHECK(floor.GetColorAtPoint(-1e300, -1e300) == CColor(10, 20, 30));
  CHECK(floor.GetColorAtPoint(9.5, 1e9) == CColor::GREEN);
  CHECK_NOTHROW(floor.GetColorAtPoint(std::numeric_limits<Real>::quiet_NaN(), 0.0));
}

TEST_CASE("floor: environment variables in the path are expanded", "[core][floor]") {
  const CFolder folder;
  WriteImage(folder.File("image.ppm"));
  REQUIRE(setenv("ARGOS_FLOOR_TEST_FOLDER", folder.Path().c_str(), 1) == 0);
  CWorld world(ImageFloor("$ARGOS_FLOOR_TEST_FOLDER/image.ppm"));
  CHECK(world.Floor().GetColorAtPoint(9.5, 20.5) == CColor::GREEN);
}

TEST_CASE("floor: a missing image is named as given and as looked for", "[core][floor]") {
  const std::string error = ErrorOf(ImageFloor("no/such/image.png"));
  CHECK_THAT(error, Contains("floor.argos:4") && Contains("\"no/such/image.png\""));
  CHECK_THAT(error, Contains((std::filesystem::current_path() / "no/such/image.png").string()));
}

TEST_CASE("floor: a file that is no image is refused", "[core][floor]") {
  const CFolder folder;
  std::ofstream(folder.File("text.txt")) << "this is no image";
  CHECK_THAT(ErrorOf(ImageFloor(folder.File("text.txt"))), Contains("no image format"));
  std::ofstream(folder.File("broken.png")) << "neither is this";
  CHECK_THAT(ErrorOf(ImageFloor(folder.File("broken.png"))), Contains("broken.png"));
}

TEST_CASE("floor: wrong attributes are refused", "[core][floor]") {
  CHECK_THAT(ErrorOf("<floor id=\"f\" source=\"imgae\"/>"), Contains("\"image\""));
  CHECK_THAT(ErrorOf("<floor id=\"f\" source=\"image\"/>"), Contains("path"));
  CHECK_THAT(ErrorOf("<floor id=\"f\" source=\"loop_functions\"/>"), Contains("pixels_per_meter"));
  CHECK_THAT(ErrorOf("<floor id=\"f\" source=\"loop_functions\" pixels_per_meter=\"0\"/>"),
             Contains("at least 1"));
  CHECK_THAT(ErrorOf("<floor id=\"f\" source=\"loop_functions\" pixels_per_meter=\"-5\"/>"),
             Contains("-5"));
}

TEST_CASE("floor: loop functions colour it, by default in white", "[core][floor]") {
  const std::string floor = "<floor id=\"f\" source=\"loop_functions\" pixels_per_meter=\"10\"/>";
  CWorld plain(floor);
  CHECK(plain.Floor().GetColorAtPoint(-1.0, 0.0) == CColor::WHITE);
  CWorld halves(floor, "<loop_functions label=\"floor_test_loop_functions\"/>");
  CHECK(halves.Floor().GetColorSource() == CFloorEntity::FROM_LOOP_FUNCTIONS);
  CHECK(halves.Floor().GetPixelsPerMeter() == 10);
  CHECK(halves.Floor().GetColorAtPoint(-1.0, 0.0) == CColor::BLACK);
  CHECK(halves.Floor().GetColorAtPoint(1.0, 0.0) == CColor::WHITE);
}

TEST_CASE("floor: without one the space says so", "[core][floor]") {
  CWorld world("");
  CHECK_FALSE(world.Space().HasFloorEntity());
  CHECK_THROWS_AS(world.Space().GetFloorEntity(), CARGoSException);
}

TEST_CASE("floor: what is saved as an image reads back the same", "[core][floor]") {
  const CFolder folder;
  WriteImage(folder.File("image.ppm"));
  {
    CWorld world(ImageFloor(folder.File("image.ppm")));
    world.Floor().SaveAsImage(folder.File("copy.png"));
    CHECK_THROWS_WITH(world.Floor().SaveAsImage(folder.File("copy.unknown")),
                      Contains("extension"));
    CHECK_THROWS_WITH(world.Floor().SaveAsImage(folder.File("no/folder/copy.png")),
                      Contains("cannot write"));
  }
  CWorld copy(ImageFloor(folder.File("copy.png")));
  CHECK(copy.Floor().GetColorAtPoint(8.5, 19.5) == CColor(10, 20, 30));
  CHECK(copy.Floor().GetColorAtPoint(11.5, 20.5) == CColor::WHITE);
}

TEST_CASE("floor: the change mark is set until it is cleared", "[core][floor]") {
  CWorld world("<floor id=\"f\" source=\"loop_functions\" pixels_per_meter=\"10\"/>");
  CFloorEntity& floor = world.Floor();
  CHECK(floor.HasChanged());
  floor.ClearChanged();
  CHECK_FALSE(floor.HasChanged());
  floor.SetChanged();
  CHECK(floor.HasChanged());
  floor.ClearChanged();
  floor.Reset();
  CHECK(floor.HasChanged());
}
