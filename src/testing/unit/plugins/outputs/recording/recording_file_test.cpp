#include <argos3/plugins/simulator/outputs/recording/format/frame_coding.h>
#include <argos3/plugins/simulator/outputs/recording/format/recording_blocks.h>
#include <argos3/plugins/simulator/outputs/recording/format/recording_reader.h>
#include <argos3/plugins/simulator/outputs/recording/format/recording_writer.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/testing/support/temporary_folder.h>

#include <catch2/catch.hpp>

#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <random>
#include <thread>

namespace recording_file_test {

using namespace argos;
using Catch::Contains;

namespace {

/* A file of its own, removed at the end. */
class CFile {
 public:
  std::string GetPath() const { return m_folder.Path("run.rec"); }
  std::string Read() const { return m_folder.Read("run.rec"); }
  void Write(const std::string& content) const { m_folder.Write("run.rec", content); }

 private:
  CTemporaryFolder m_folder;
};

SRecordingInfo MakeInfo() {
  SRecordingInfo info;
  info.ExperimentFile = "e.argos";
  info.Experiment = "<argos-configuration/>";
  info.Overrides = {{"a/@b", "c"}};
  info.Seed = 42;
  info.TickLength = 0.05;
  return info;
}

// a place that moves along x by 1 m a tick; the words differ so much that nothing packs them
SFrameUpdate MakeUpdate(UInt32 tick, std::mt19937& random) {
  constexpr UInt32 kLEDs = 999;
  SFrameUpdate update;
  update.Tick = tick;
  if (tick == 0) {
    SRecordedType type;
    type.Kind = SRecordedType::EKind::Place;
    type.Tag = "thing";
    type.NumLEDs = kLEDs;
    update.IsRestart = true;
    update.NewTypes.push_back(type);
    update.Added.push_back({"thing", 0});
  }
  update.Poses.push_back({CVector3(tick, 0.0, 0.0), CQuaternion()});
  for (UInt32 i = 0; i <= kLEDs; ++i) {
    update.Words.push_back(static_cast<UInt32>(random()));
  }
  return update;
}

// blocks have 100 frames: this one has three, of 100, 100 and 50
constexpr UInt32 kFrames = 250;

void Record(const CFile& file) {
  std::mt19937 random(1);
  CRecordingWriter writer(file.GetPath(), MakeInfo());
  for (UInt32 tick = 0; tick < kFrames; ++tick) {
    writer.Add(MakeUpdate(tick, random));
  }
  writer.Close();
}

// @return the last tick. Checks that all states up to it are there
UInt32 CheckStates(CRecordingReader& reader) {
  reader.Seek(0);
  UInt32 tick = 0;
  for (const SRecordedFrame* frame = reader.ReadNext(); frame != nullptr;
       frame = reader.ReadNext()) {
    REQUIRE(frame->Tick == tick);
    REQUIRE(frame->Poses[0].Position.GetX() == tick);
    ++tick;
  }
  return tick - 1;
}

std::string ErrorOf(const CFile& file) {
  try {
    CRecordingReader reader(file.GetPath());
    CheckStates(reader);
  } catch (const CARGoSException& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("recording: what was written is read", "[core][recording]") {
  const CFile file;
  Record(file);
  CRecordingReader reader(file.GetPath());
  CHECK(reader.GetWarning().empty());
  CHECK(reader.GetInfo().Experiment == "<argos-configuration/>");
  CHECK(reader.GetInfo().Overrides == MakeInfo().Overrides);
  CHECK(reader.GetInfo().Seed == 42);
  CHECK(reader.GetInfo().TickLength == 0.05);
  CHECK(reader.GetFirstTick() == 0);
  CHECK(reader.GetLastTick() == kFrames - 1);
  CHECK(CheckStates(reader) == kFrames - 1);
}

TEST_CASE("recording: its sizes are those of the coded frames and of the file",
          "[core][recording]") {
  const CFile file;
  std::mt19937 random(1);
  CRecordingWriter writer(file.GetPath(), MakeInfo());
  std::mt19937 again(1);
  CFrameEncoder encoder(MakeInfo().Precision);
  std::string coded;
  for (UInt32 tick = 0; tick < kFrames; ++tick) {
    writer.Add(MakeUpdate(tick, random));
    SFrameUpdate update = MakeUpdate(tick, again);
    encoder.Encode(update, tick % 100 == 0, coded);
  }
  writer.Close();
  CHECK(writer.GetNumCodedBytes() == coded.size());
  CHECK(writer.GetNumWrittenBytes() == file.Read().size());
}

TEST_CASE("recording: what was recorded is in the file a second later, also if the run waits",
          "[core][recording]") {
  const CFile file;
  std::mt19937 random(1);
  CRecordingWriter writer(file.GetPath(), MakeInfo());
  UInt32 added = 0;
  // the last ones do not fill a block
  for (const UInt32 end : {3U, 5U}) {
    for (; added < end; ++added) {
      writer.Add(MakeUpdate(added, random));
    }
    const auto start = std::chrono::steady_clock::now();
    const auto isThere = [&] {
      try {
        return CRecordingReader(file.GetPath()).GetLastTick() == end - 1;
      } catch (const CARGoSException&) {
        return false;
      }
    };
    while (!isThere() && std::chrono::steady_clock::now() - start < std::chrono::seconds(10)) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    CHECK(isThere());
  }
  writer.Close();
}

TEST_CASE("recording: reading begins at any tick", "[core][recording]") {
  const CFile file;
  Record(file);
  CRecordingReader reader(file.GetPath());
  for (const UInt32 tick : {249u, 0u, 99u, 100u, 101u, 173u}) {
    reader.Seek(tick);
    const SRecordedFrame* const frame = reader.ReadNext();
    REQUIRE(frame != nullptr);
    CHECK(frame->Tick == tick);
    CHECK(reader.FindLastTickUpTo(tick) == tick);
  }
  reader.Seek(kFrames);
  CHECK(reader.ReadNext() == nullptr);
}

TEST_CASE("recording: cut anywhere, it is read up to its last whole block", "[core][recording]") {
  const CFile file;
  Record(file);
  const std::string whole = file.Read();
  std::mt19937 random(3);
  for (int i = 0; i < 100; ++i) {
    const size_t size = 1 + random() % (whole.size() - 1);
    CAPTURE(size);
    file.Write(whole.substr(0, size));
    try {
      CRecordingReader reader(file.GetPath());
      const UInt32 last = CheckStates(reader);
      CHECK((last == 99 || last == 199 || last == 249));
      CHECK_THAT(reader.GetWarning(), Contains("was not finished") &&
                                          Contains("ends with tick " + std::to_string(last)));
    } catch (const CARGoSException& error) {
      // less than one block of states
      CHECK(size < whole.size() / 2);
      CHECK_THAT(error.what(), Contains("run.rec"));
    }
  }
}

TEST_CASE("recording: a file of zeros behind the last block is not read", "[core][recording]") {
  const CFile file;
  Record(file);
  const std::string whole = file.Read();
  file.Write(whole.substr(0, whole.size() - kFileFooterSize) + std::string(5000, '\0'));
  CRecordingReader reader(file.GetPath());
  CHECK(CheckStates(reader) == kFrames - 1);
  CHECK_THAT(reader.GetWarning(), Contains("5000 bytes are not used"));
}

TEST_CASE("recording: a changed byte is noticed", "[core][recording]") {
  const CFile file;
  Record(file);
  const std::string whole = file.Read();
  // in the middle: the content of a block of frames
  std::string changed = whole;
  changed[whole.size() / 2] = static_cast<char>(changed[whole.size() / 2] ^ 1);
  file.Write(changed);
  CHECK_THAT(ErrorOf(file), Contains("run.rec\" is damaged in the block at byte") &&
                                Contains("its checksum is wrong"));
  // anywhere: an error, or a place that is not needed, such as the index
  std::mt19937 random(4);
  for (int i = 0; i < 100; ++i) {
    changed = whole;
    char& byte = changed[random() % changed.size()];
    byte = static_cast<char>(byte ^ (1 << random() % 8));
    file.Write(changed);
    ErrorOf(file);
  }
}

TEST_CASE("recording: other files are refused", "[core][recording]") {
  const CFile file;
  CHECK_THROWS_WITH(CRecordingReader(file.GetPath()),
                    Contains("cannot open the recording") && Contains("No such file"));
  file.Write("");
  CHECK_THAT(ErrorOf(file), Contains("is no recording: it is empty"));
  file.Write("<argos-configuration/>");
  CHECK_THAT(ErrorOf(file), Contains("is no recording: it does not begin with \"ARGOSREC\"") &&
                                Contains("an experiment file goes after -c"));
  file.Write("");
  Record(file);
  std::string newer = file.Read();
  newer[8] = 2;
  file.Write(newer);
  CHECK_THAT(ErrorOf(file), Contains("has version 2 of the format") &&
                                Contains("reads versions up to 1") &&
                                Contains("needs a newer version of argos3"));
}

TEST_CASE("recording: blocks that are not in the order of their ticks are refused",
          "[core][recording]") {
  const CFile file;
  Record(file);
  const std::string content = file.Read();
  std::vector<std::string> frames;
  std::string rest = content.substr(kFileHeaderSize);
  std::string before = content.substr(0, kFileHeaderSize);
  for (;;) {
    const SBlockHeader header = ReadBlockHeader(rest.substr(0, kBlockHeaderSize)).value();
    if (header.Kind == EBlock::Index) {
      break;
    }
    const std::string block = rest.substr(0, kBlockHeaderSize + header.PackedSize);
    rest.erase(0, block.size());
    if (header.Kind == EBlock::Frames) {
      frames.push_back(block);
    } else {
      REQUIRE(frames.empty());
      before += block;
    }
  }
  REQUIRE(frames.size() == 3);
  // without its index, as after a crash
  file.Write(before + frames[0] + frames[1]);
  CHECK(ErrorOf(file).empty());
  file.Write(before + frames[1] + frames[0]);
  CHECK_THAT(ErrorOf(file), Contains("its ticks are not in order"));
  file.Write(before + frames[0] + frames[0]);
  CHECK_THAT(ErrorOf(file), Contains("its ticks are not in order"));
}

TEST_CASE("recording: a file that is no recording is not overwritten", "[core][recording]") {
  const CFile file;
  file.Write("precious");
  CHECK_THROWS_WITH(CRecordingWriter(file.GetPath(), MakeInfo()),
                    Contains("cannot write the recording") &&
                        Contains("that is no recording, and it is not overwritten"));
  CHECK(file.Read() == "precious");
  // an empty file and an older recording are
  file.Write("");
  Record(file);
  Record(file);
  CRecordingReader reader(file.GetPath());
  CHECK(CheckStates(reader) == kFrames - 1);
}

TEST_CASE("recording: a full disk is an error of the next frames", "[core][recording]") {
  CHECK_THROWS_WITH(CRecordingWriter("/dev/full", MakeInfo()),
                    Contains("cannot write the recording \"/dev/full\": No space left on device"));
  CHECK_THROWS_WITH(CRecordingWriter("/nowhere/run.rec", MakeInfo()),
                    Contains("No such file or directory"));
  CHECK_THROWS_WITH(CRecordingWriter("/", MakeInfo()), Contains("it is a directory"));
}

TEST_CASE("recording: two writers of one file are refused", "[core][recording]") {
  const CFile file;
  CRecordingWriter first(file.GetPath(), MakeInfo());
  CHECK_THROWS_WITH(CRecordingWriter(file.GetPath(), MakeInfo()),
                    Contains("this process is writing it"));
}

}  // namespace recording_file_test
