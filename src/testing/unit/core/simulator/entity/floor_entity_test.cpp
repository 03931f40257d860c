#include <argos3/core/simulator/entity/floor_entity.h>

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/visualization/floor_samples.h>
#include <argos3/testing/support/temporary_folder.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace floor_entity_test {

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

// 4 x 2 pixels. In the file, the upper row comes first.
void WriteImage(const std::string& path) {
  std::ofstream(path) << "P3 4 2 255\n"
                         "255 0 0   0 255 0   0 0 255   255 255 255\n"
                         "10 20 30  40 50 60  70 80 90  100 110 120\n";
}

// an arena of 4 m x 2 m around (10, 20): each pixel covers a square metre
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

// test image of 5 x 3 distinct colours or grey levels, lowest row first
constexpr size_t kWidth = 5, kHeight = 3;

CColor ColorOf(size_t column, size_t row, bool grey = false) {
  const auto level = static_cast<UInt8>(7 + 40 * row + 11 * column);
  return grey ? CColor(level, level, level)
              : CColor(level, static_cast<UInt8>(250 - 50 * column),
                       static_cast<UInt8>(3 + 100 * row));
}

enum class EOrder { RGB, BGR, BGRA, Grey };

// the pixels as bytes; each row is padded to a multiple of the given number of bytes
std::string Bytes(EOrder order, bool topRowFirst, size_t multiple = 1) {
  std::string bytes;
  for (size_t i = 0; i < kHeight; ++i) {
    const size_t row = topRowFirst ? kHeight - 1 - i : i;
    for (size_t column = 0; column < kWidth; ++column) {
      const CColor color = ColorOf(column, row, order == EOrder::Grey);
      std::string pixel = {static_cast<char>(color.GetBlue()), static_cast<char>(color.GetGreen()),
                           static_cast<char>(color.GetRed())};
      if (order == EOrder::RGB) {
        std::reverse(pixel.begin(), pixel.end());
      } else if (order == EOrder::Grey) {
        pixel.resize(1);
      } else if (order == EOrder::BGRA) {
        // half transparent: the floor ignores alpha
        pixel += static_cast<char>(128);
      }
      bytes += pixel;
    }
    while (bytes.size() % multiple != 0) {
      bytes += '\0';
    }
  }
  return bytes;
}

// a number in the given count of bytes, least significant first
std::string Number(SInt32 value, int bytes) {
  std::string text;
  UInt32 rest = static_cast<UInt32>(value);
  for (int i = 0; i < bytes; ++i) {
    text += static_cast<char>(rest & 0xff);
    rest >>= 8;
  }
  return text;
}

// BMP: BITMAPFILEHEADER and BITMAPINFOHEADER, rows from the bottom unless the height is negative
std::string Bmp(bool topRowFirst) {
  const std::string pixels = Bytes(EOrder::BGR, topRowFirst, 4);
  return "BM" + Number(static_cast<SInt32>(54 + pixels.size()), 4) + Number(0, 4) + Number(54, 4) +
         Number(40, 4) + Number(kWidth, 4) +
         Number(topRowFirst ? -static_cast<SInt32>(kHeight) : SInt32(kHeight), 4) + Number(1, 2) +
         Number(24, 2) + std::string(24, '\0') + pixels;
}

// TGA, not compressed; bit 5 of its last byte: the top row comes first
std::string Tga(EOrder order, bool topRowFirst) {
  const bool grey = order == EOrder::Grey;
  const int bits = grey ? 8 : (order == EOrder::BGR ? 24 : 32);
  return Number(0, 2) + Number(grey ? 3 : 2, 1) + Number(0, 9) + Number(kWidth, 2) +
         Number(kHeight, 2) + Number(bits, 1) +
         Number((topRowFirst ? 32 : 0) + (bits == 32 ? 8 : 0), 1) + Bytes(order, topRowFirst);
}

// PPM and PGM always have the top row first
std::string Pnm(bool grey) {
  return std::string(grey ? "P5" : "P6") + "\n5 3\n255\n" +
         Bytes(grey ? EOrder::Grey : EOrder::RGB, true);
}

void WriteFile(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

// checks every pixel, at its middle and just inside its four corners; the
// arena is 4 m x 2 m around (10, 20)
void CheckEveryPixel(CFloorEntity& floor, bool grey = false) {
  for (size_t row = 0; row < kHeight; ++row) {
    for (size_t column = 0; column < kWidth; ++column) {
      for (const Real x : {1e-6, 0.5, 1.0 - 1e-6}) {
        for (const Real y : {1e-6, 0.5, 1.0 - 1e-6}) {
          CAPTURE(row, column, x, y);
          CHECK(floor.GetColorAtPoint(8.0 + (column + x) * 4.0 / kWidth,
                                      19.0 + (row + y) * 2.0 / kHeight) ==
                ColorOf(column, row, grey));
        }
      }
    }
  }
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
  const CTemporaryFolder folder;
  WriteImage(folder.Path("image.ppm"));
  CWorld world(ImageFloor(folder.Path("image.ppm")));
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

TEST_CASE("floor: pixels are in the right places for every row order of the image formats",
          "[core][floor]") {
  const CTemporaryFolder folder;
  CWorld world("");
  const auto check = [&](const std::string& name, const std::string& bytes, bool grey = false) {
    CAPTURE(name);
    WriteFile(folder.Path(name), bytes);
    CFloorEntity floor("f", folder.Path(name));
    CHECK(floor.GetColorSource() == CFloorEntity::FROM_IMAGE);
    // 5 pixels on 4 m, 3 on 2 m: the finer resolution is 1.5 pixels per metre, rounded up
    CHECK(floor.GetPixelsPerMeter() == 2);
    CheckEveryPixel(floor, grey);
  };
  check("image.ppm", Pnm(false));
  check("grey.pgm", Pnm(true), true);
  check("from_bottom.bmp", Bmp(false));
  check("from_top.bmp", Bmp(true));
  check("from_bottom.tga", Tga(EOrder::BGR, false));
  check("from_top.tga", Tga(EOrder::BGR, true));
  check("transparent.tga", Tga(EOrder::BGRA, true));
  check("grey.tga", Tga(EOrder::Grey, false), true);
}

TEST_CASE("floor: views take each pixel of an image once", "[core][floor]") {
  const CTemporaryFolder folder;
  WriteFile(folder.Path("image.ppm"), Pnm(false));
  CWorld world(ImageFloor(folder.Path("image.ppm")));
  CFloorEntity& floor = world.Floor();
  // although a pixel is 0.8 m wide and 0.67 m high
  CHECK(floor.GetImageWidth() == kWidth);
  CHECK(floor.GetImageHeight() == kHeight);
  const SFloorSamples samples =
      SampleFloor(floor, world.Space().GetArenaCenter(), world.Space().GetArenaSize());
  REQUIRE(samples.Width == kWidth);
  REQUIRE(samples.Height == kHeight);
  for (size_t row = 0; row < kHeight; ++row) {
    for (size_t column = 0; column < kWidth; ++column) {
      CAPTURE(row, column);
      const UInt8* const pixel = &samples.Pixels[4 * (row * kWidth + column)];
      CHECK(CColor(pixel[0], pixel[1], pixel[2]) == ColorOf(column, row));
    }
  }
}

TEST_CASE("floor: a saved image has its top row at the greatest y", "[core][floor]") {
  const CTemporaryFolder folder;
  WriteFile(folder.Path("image.bmp"), Bmp(false));
  CWorld world("", "<loop_functions label=\"floor_test_loop_functions\"/>");
  CFloorEntity floor("f", folder.Path("image.bmp"));
  // PPM is compared byte by byte; the other lossless formats are read back
  floor.SaveAsImage(folder.Path("copy.ppm"));
  std::ostringstream saved;
  saved << std::ifstream(folder.Path("copy.ppm"), std::ios::binary).rdbuf();
  CHECK_THAT(saved.str(), Catch::EndsWith(Bytes(EOrder::RGB, true)));
  for (const char* const name : {"copy.png", "copy.bmp", "copy.tga"}) {
    CAPTURE(name);
    floor.SaveAsImage(folder.Path(name));
    CFloorEntity copy("copy", folder.Path(name));
    CheckEveryPixel(copy);
  }

  // The loop functions return black where x < 0. The arena so far lies at x > 0, so move it.
  world.Space().SetArenaCenter(CVector3(0.5, 0.0, 0.0));
  CFloorEntity painted("painted", 2);
  painted.SaveAsImage(folder.Path("painted.ppm"));
  std::ostringstream pixels;
  pixels << std::ifstream(folder.Path("painted.ppm"), std::ios::binary).rdbuf();
  // x from -1.5 to 2.5 in 8 pixels, y in 4: three of each row are black
  std::string expected;
  for (int row = 0; row < 4; ++row) {
    expected += std::string(size_t(3) * 3, '\0') + std::string(size_t(5) * 3, '\xff');
  }
  CHECK_THAT(pixels.str(), Catch::Contains("8 4") && Catch::EndsWith(expected));
}

TEST_CASE("floor: constructed by a program, wrong arguments are refused with the reason",
          "[core][floor]") {
  CWorld world("");
  CHECK_THROWS_WITH(CFloorEntity("f", "no/such/image.png"), Contains("no/such/image.png"));
  CHECK_THROWS_WITH(CFloorEntity("f", UInt32(0)), Contains("at least one pixel"));
  CHECK_THROWS_AS(world.Space().GetFloorEntity(), CARGoSException);
}

TEST_CASE("floor: outside the arena it has the colour of the nearest edge", "[core][floor]") {
  const CTemporaryFolder folder;
  WriteImage(folder.Path("image.ppm"));
  CWorld world(ImageFloor(folder.Path("image.ppm")));
  CFloorEntity& floor = world.Floor();
  CHECK(floor.GetColorAtPoint(12.0, 21.0) == CColor::WHITE);
  CHECK(floor.GetColorAtPoint(1e300, 1e300) == CColor::WHITE);
  CHECK(floor.GetColorAtPoint(-1e300, -1e300) == CColor(10, 20, 30));
  CHECK(floor.GetColorAtPoint(9.5, 1e9) == CColor::GREEN);
  CHECK_NOTHROW(floor.GetColorAtPoint(std::numeric_limits<Real>::quiet_NaN(), 0.0));
}

TEST_CASE("floor: environment variables in the path are expanded", "[core][floor]") {
  const CTemporaryFolder folder;
  WriteImage(folder.Path("image.ppm"));
  REQUIRE(setenv("ARGOS_FLOOR_TEST_FOLDER", folder.GetPath().c_str(), 1) == 0);
  CWorld world(ImageFloor("$ARGOS_FLOOR_TEST_FOLDER/image.ppm"));
  CHECK(world.Floor().GetColorAtPoint(9.5, 20.5) == CColor::GREEN);
}

TEST_CASE("floor: the error on a missing image gives the path in the file and the paths tried",
          "[core][floor]") {
  const std::string error = ErrorOf(ImageFloor("no/such/image.png"));
  CHECK_THAT(error, Contains("floor.argos:4") && Contains("\"no/such/image.png\""));
  CHECK_THAT(error, Contains((std::filesystem::current_path() / "no/such/image.png").string()));
}

TEST_CASE("floor: a file that is not an image is refused", "[core][floor]") {
  const CTemporaryFolder folder;
  std::ofstream(folder.Path("text.txt")) << "this is no image";
  CHECK_THAT(ErrorOf(ImageFloor(folder.Path("text.txt"))), Contains("no image format"));
  std::ofstream(folder.Path("broken.png")) << "neither is this";
  CHECK_THAT(ErrorOf(ImageFloor(folder.Path("broken.png"))), Contains("broken.png"));
}

TEST_CASE("floor: an image that is too large is refused before its pixels are read",
          "[core][floor]") {
  // a PNG file of which only the head is there: 60,000 x 60,000 pixels would take 10.8 GB
  const CTemporaryFolder folder;
  const unsigned char head[] = {0x89, 'P',  'N', 'G', 0x0d, 0x0a, 0x1a, 0x0a, 0,    0,    0,
                                13,   'I',  'H', 'D', 'R',  0,    0,    0xea, 0x60, 0,    0,
                                0xea, 0x60, 8,   2,   0,    0,    0,    0x0f, 0xb0, 0xe2, 0x15,
                                0,    0,    0,   1,   'I',  'D',  'A',  'T'};
  std::ofstream(folder.Path("large.png"), std::ios::binary)
      .write(reinterpret_cast<const char*>(head), sizeof(head));
  CHECK_THAT(ErrorOf(ImageFloor(folder.Path("large.png"))),
             Contains("has 60000 x 60000 pixels; at most 268435456 are possible"));
}

TEST_CASE("floor: two are an error that names the first", "[core][floor]") {
  const std::string floor =
      "<floor id=\"NAME\" source=\"loop_functions\" pixels_per_meter=\"10\"/>\n";
  std::string two = floor + floor;
  two.replace(two.find("NAME"), 4, "one");
  two.replace(two.find("NAME"), 4, "two");
  CHECK_THAT(ErrorOf(two),
             Contains("floor.argos:5") &&
                 Contains("there is already a floor, \"one\" at floor.argos:4: an arena has one"));
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

TEST_CASE("floor: loop functions give the colours, by default white", "[core][floor]") {
  const std::string floor = "<floor id=\"f\" source=\"loop_functions\" pixels_per_meter=\"10\"/>";
  CWorld plain(floor);
  CHECK(plain.Floor().GetColorAtPoint(-1.0, 0.0) == CColor::WHITE);
  CWorld halves(floor, "<loop_functions label=\"floor_test_loop_functions\"/>");
  CHECK(halves.Floor().GetColorSource() == CFloorEntity::FROM_LOOP_FUNCTIONS);
  CHECK(halves.Floor().GetPixelsPerMeter() == 10);
  CHECK(halves.Floor().GetColorAtPoint(-1.0, 0.0) == CColor::BLACK);
  CHECK(halves.Floor().GetColorAtPoint(1.0, 0.0) == CColor::WHITE);
}

TEST_CASE("floor: in a space without a floor, access is an error", "[core][floor]") {
  CWorld world("");
  CHECK_FALSE(world.Space().HasFloorEntity());
  CHECK_THROWS_AS(world.Space().GetFloorEntity(), CARGoSException);
}

TEST_CASE("floor: an image that was saved and read again has the same colours", "[core][floor]") {
  const CTemporaryFolder folder;
  WriteImage(folder.Path("image.ppm"));
  {
    CWorld world(ImageFloor(folder.Path("image.ppm")));
    world.Floor().SaveAsImage(folder.Path("copy.png"));
    CHECK_THROWS_WITH(world.Floor().SaveAsImage(folder.Path("copy.unknown")),
                      Contains("extension"));
    CHECK_THROWS_WITH(world.Floor().SaveAsImage(folder.Path("no/folder/copy.png")),
                      Contains("cannot write"));
  }
  CWorld copy(ImageFloor(folder.Path("copy.png")));
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

}  // namespace floor_entity_test
