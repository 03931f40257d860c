#include <argos3/plugins/simulator/visualizations/offscreen/frame_writer.h>

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/testing/support/temporary_folder.h>

#include <catch2/catch.hpp>

#include <FreeImage.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace frame_writer_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

// 3 x 2 pixels: red, green, blue above white, black, grey
SPicture MakePicture() {
  SPicture picture;
  picture.Width = 3;
  picture.Height = 2;
  picture.Pixels = {255, 0,   0,   255, 0, 255, 0, 255, 0,   0,   255, 255,
                    255, 255, 255, 255, 0, 0,   0, 255, 128, 128, 128, 255};
  return picture;
}

SFrameFileSettings In(const std::string& directory) {
  SFrameFileSettings settings;
  settings.Directory = directory;
  return settings;
}

}  // namespace

TEST_CASE("frame writer: file names consist of base, tick with ten digits, and format",
          "[visualizations][offscreen][frames]") {
  const CTemporaryFolder folder;
  SFrameFileSettings settings = In(folder.GetPath() + "/");
  settings.BaseName = "shot-";
  settings.Format = "bmp";
  CFrameWriter writer(settings);
  CHECK(writer.MakeFileName(0) == folder.GetPath() + "/shot-0000000000.bmp");
  CHECK(writer.MakeFileName(1234567) == folder.GetPath() + "/shot-0001234567.bmp");
  CHECK(writer.MakeFileName(4294967295u) == folder.GetPath() + "/shot-4294967295.bmp");
}

TEST_CASE("frame writer: a picture read from its file equals the original",
          "[visualizations][offscreen][frames]") {
  const CTemporaryFolder folder;
  SFrameFileSettings settings = In(folder.GetPath());
  settings.Quality = GENERATE(-1, 0, 50, 100);
  CAPTURE(settings.Quality);
  CFrameWriter writer(settings);
  const SPicture picture = MakePicture();
  writer.Write(picture, 3);
  CHECK(folder.List() == std::vector<std::string>{"frame_0000000003.png"});

  FIBITMAP* bitmap = FreeImage_Load(FIF_PNG, writer.MakeFileName(3).c_str());
  REQUIRE(bitmap != nullptr);
  REQUIRE(FreeImage_GetWidth(bitmap) == 3);
  REQUIRE(FreeImage_GetHeight(bitmap) == 2);
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) {
      CAPTURE(x, y);
      RGBQUAD color;
      REQUIRE(FreeImage_GetPixelColor(bitmap, static_cast<unsigned>(x),
                                      static_cast<unsigned>(1 - y), &color));
      CHECK(color.rgbRed == picture.At(x, y)[0]);
      CHECK(color.rgbGreen == picture.At(x, y)[1]);
      CHECK(color.rgbBlue == picture.At(x, y)[2]);
    }
  }
  FreeImage_Unload(bitmap);
}

TEST_CASE("frame writer: a lower quality gives smaller files",
          "[visualizations][offscreen][frames]") {
  const CTemporaryFolder folder;
  SPicture picture;
  picture.Width = 64;
  picture.Height = 64;
  // smooth enough to be compressed, but with some detail
  for (int i = 0; i < 64 * 64; ++i) {
    const auto level = static_cast<std::uint8_t>((i * i / 64) % 251);
    picture.Pixels.insert(picture.Pixels.end(), {level, level, level, 255});
  }
  const std::string format = GENERATE("png", "jpg");
  CAPTURE(format);
  SFrameFileSettings settings = In(folder.GetPath());
  settings.Format = format;
  settings.Quality = 0;
  CFrameWriter small(settings);
  small.Write(picture, 0);
  const auto smallSize = std::filesystem::file_size(small.MakeFileName(0));
  settings.Quality = 100;
  CFrameWriter large(settings);
  large.Write(picture, 1);
  CHECK(smallSize < std::filesystem::file_size(large.MakeFileName(1)));
}

TEST_CASE("frame writer: a missing directory is created, or an error if it must exist",
          "[visualizations][offscreen][frames]") {
  const CTemporaryFolder folder;
  SFrameFileSettings settings = In(folder.GetPath() + "/a/b");
  settings.CreateDirectory = false;
  CHECK_THROWS_WITH(CFrameWriter(settings),
                    Contains("/a/b\"") && Contains("there is no such directory"));
  settings.CreateDirectory = true;
  CFrameWriter writer(settings);
  CHECK(std::filesystem::is_directory(folder.GetPath() + "/a/b"));
}

TEST_CASE("frame writer: a file in place of the directory is an error",
          "[visualizations][offscreen][frames]") {
  const CTemporaryFolder folder;
  std::ofstream(folder.GetPath() + "/file") << "x";
  CHECK_THROWS_WITH(CFrameWriter(In(folder.GetPath() + "/file")),
                    Contains("it is not a directory"));
}

TEST_CASE("frame writer: unknown formats and qualities out of range are errors",
          "[visualizations][offscreen][frames]") {
  const CTemporaryFolder folder;
  SFrameFileSettings settings = In(folder.GetPath());
  settings.Format = GENERATE("", "mp4", "pngg");
  CAPTURE(settings.Format);
  CHECK_THROWS_WITH(CFrameWriter(settings),
                    Contains("\"" + settings.Format + "\"") && Contains("png"));
  settings.Format = "png";
  settings.Quality = 101;
  CHECK_THROWS_WITH(CFrameWriter(settings), Contains("101") && Contains("0 to 100"));
  settings.Quality = -2;
  CHECK_THROWS_AS(CFrameWriter(settings), CARGoSException);
}

TEST_CASE("frame writer: an error on a frame names its file, and no partial file is left",
          "[visualizations][offscreen][frames]") {
  const CTemporaryFolder folder;
  CFrameWriter writer(In(folder.GetPath()));
  // a folder that is not empty cannot be replaced by a file
  std::filesystem::create_directories(writer.MakeFileName(8) + "/inside");
  CHECK_THROWS_WITH(writer.Write(MakePicture(), 8), Contains("frame_0000000008.png\""));
  CHECK(folder.List() == std::vector<std::string>{"frame_0000000008.png"});
}

}  // namespace frame_writer_test
