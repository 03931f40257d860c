#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/files/file_replacement.h>
#include <argos3/plugins/simulator/visualizations/offscreen/film_frames.h>
#include <argos3/plugins/simulator/visualizations/offscreen/film_writer.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/temporary_folder.h>

#include <catch2/catch.hpp>

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace film_writer_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

namespace fs = std::filesystem;

// with programs in place of ffmpeg
class CFilmFolder : public CTemporaryFolder {
 public:
  // its last argument is the file, as file:PATH
  std::string MakeProgram(const std::string& script) const {
    std::ofstream(Path("program")) << "#!/bin/sh\nfor file; do :; done\nfile=${file#file:}\n"
                                   << script << "\n";
    ::chmod(Path("program").c_str(), 0755);
    return Path("program");
  }

  std::vector<std::string> List(const std::string& folder = ".") const {
    std::vector<std::string> names = CTemporaryFolder::List(folder);
    std::erase(names, "program");
    return names;
  }

  SFilmSettings Film(const std::string& name) const {
    SFilmSettings settings;
    settings.File = Path(name);
    return settings;
  }
};

SPicture MakePicture(std::uint8_t level) {
  SPicture picture;
  picture.Width = 64;
  picture.Height = 32;
  picture.Pixels.assign(64 * 32 * 4, level);
  return picture;
}

void WriteRun(CPictureSink& sink, int pictures) {
  sink.Begin();
  for (int i = 0; i < pictures; ++i) {
    sink.Write(MakePicture(static_cast<std::uint8_t>(i)), static_cast<std::uint32_t>(i));
  }
  sink.Finish();
}

typedef std::vector<std::string> TNames;

}  // namespace

TEST_CASE("film writer: the encoder gets every picture, and each run has a film of its own",
          "[visualizations][offscreen][films]") {
  const CFilmFolder folder;
  CFilmWriter writer(folder.Film("new/a.mp4"), folder.MakeProgram("cat > \"$file\""));
  WriteRun(writer, 3);
  WriteRun(writer, 1);  // its only picture tells no frame rate
  WriteRun(writer, 0);
  CHECK_THAT(TakeLogErr(), Contains("a.3.mp4 is not written: it has no pictures"));
  CHECK(folder.List("new") == TNames{"a.2.mp4", "a.mp4"});
  CHECK(fs::file_size(folder.Path("new/a.mp4")) == 3 * 64 * 32 * 4);
  CHECK(fs::file_size(folder.Path("new/a.2.mp4")) == 64 * 32 * 4);
}

TEST_CASE("film writer: a film that is not complete has another name",
          "[visualizations][offscreen][films]") {
  const CFilmFolder folder;
  CFilmWriter writer(folder.Film("a.mp4"), folder.MakeProgram("cat > \"$file\""));
  writer.Begin();
  writer.Write(MakePicture(0), 0);
  writer.Write(MakePicture(0), 1);
  CHECK(folder.List().size() == 1);
  CHECK(fs::exists(folder.Path("a.mp4") + kPartSuffix));
  // that others do not write, and do not remove
  CFilmWriter other(folder.Film("a.mp4"), folder.MakeProgram("cat > \"$file\""));
  CHECK_THROWS_WITH(other.Begin(), Contains("this process is writing it"));
  RemoveStaleParts(folder.Path("."));
  writer.Finish();
  CHECK(folder.List() == TNames{"a.mp4"});
}

TEST_CASE("film writer: after a failure nothing stays, and the next run can be filmed",
          "[visualizations][offscreen][films]") {
  const CFilmFolder folder;
  CFilmWriter writer(folder.Film("a.mp4"), folder.MakeProgram("echo broken >&2; exit 1"));
  CHECK_THROWS_WITH(WriteRun(writer, 1000),
                    Contains("ended with exit status 1") && Contains("broken"));
  CHECK(folder.List().empty());
  writer.Finish();
  writer.Write(MakePicture(0), 5);  // ignored
  folder.MakeProgram("cat > \"$file\"");
  WriteRun(writer, 2);
  CHECK(folder.List() == TNames{"a.2.mp4"});
}

TEST_CASE("film writer: something that is no file is not replaced",
          "[visualizations][offscreen][films]") {
  const CFilmFolder folder;
  fs::create_directory(folder.Path("a.mp4"));
  CHECK_THROWS_WITH(CFilmWriter(folder.Film("a.mp4"), "ffmpeg"), Contains("that is no file"));
}

TEST_CASE("film frames: those of an earlier run are removed, and nothing else",
          "[visualizations][offscreen][films]") {
  const CFilmFolder folder;
  CFilmFrames frames(folder.Film("a.mp4"));
  fs::create_directory(folder.Path("a.mp4.frames"));
  for (const char* name : {"frame_0000000077.png", "frame_1.txt", "frame_.png", "frame_x.png"}) {
    std::ofstream(folder.Path("a.mp4.frames/") + name) << "x";
  }
  WriteRun(frames, 2);
  WriteRun(frames, 1);
  CHECK_THAT(TakeLogErr(),
             Contains("There is no ffmpeg in PATH") && Contains("a.2.mp4.frames/frame_*.png"));
  CHECK(folder.List("a.mp4.frames") == TNames{"frame_.png", "frame_0000000000.png",
                                              "frame_0000000001.png", "frame_1.txt",
                                              "frame_x.png"});
  CHECK(folder.List("a.2.mp4.frames") == TNames{"frame_0000000000.png"});
}

}  // namespace film_writer_test
