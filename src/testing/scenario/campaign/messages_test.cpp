// Messages between the processes of a campaign, and the end of a run's output.

#include <argos3/campaign/execution/message_stream.h>
#include <argos3/campaign/execution/output_tail.h>
#include <argos3/campaign/execution/run_messages.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <catch2/catch.hpp>

#include <unistd.h>

#include <cmath>
#include <limits>
#include <thread>

namespace campaign_messages_test {

using namespace argos;

namespace {

SRunResult MakeResult() {
  SRunResult result;
  result.Status = ERunStatus::TimedOut;
  result.ExitStatus = -1;
  result.Signal = 9;
  result.StartUpTime = 0.1;
  result.WallTime = 1.0 / 3.0;
  result.CPUTime = 5e-324;
  result.TotalWallTime = 1e300;
  result.PeakMemory = std::numeric_limits<UInt64>::max();
  result.Ticks = std::numeric_limits<UInt32>::max();
  result.Robots = 3;
  result.Digest = 0xfedcba9876543210;
  result.Log = std::string("a\0b\n", 4);
  result.LogBytes = 1234567;
  result.Error = "[FATAL] x";
  result.Warnings = {"[WARNING] y", ""};
  result.Metrics = {{"a", "m", -0.0}, {"b", "", std::numeric_limits<Real>::quiet_NaN()}};
  result.Series = {{"s", "kg", {1, 2}, {0.5, std::numeric_limits<Real>::infinity()}},
                   {"empty", "", {}, {}}};
  return result;
}

}  // namespace

TEST_CASE("messages: a result arrives without loss", "[campaign][messages]") {
  const SRunResult sent = MakeResult();
  const std::string bytes = EncodeResult(42, sent);
  const auto [id, result] = DecodeResult(bytes);
  CHECK(id == 42);
  // equal bytes: also NaN and the sign of zero
  CHECK(EncodeResult(42, result) == bytes);
  CHECK(result.Status == sent.Status);
  CHECK(result.Log == sent.Log);
  CHECK(result.Warnings == sent.Warnings);
  CHECK(result.Series[0].Ticks == sent.Series[0].Ticks);
  CHECK(std::signbit(result.Metrics[0].Value));
  CHECK(std::isnan(result.Metrics[1].Value));
}

TEST_CASE("messages: bytes that are cut or added are errors", "[campaign][messages]") {
  const std::string result = EncodeResult(42, MakeResult());
  SRunRequest sent;
  sent.Id = 7;
  sent.Seed = 8;
  sent.Folder = "/a b";
  sent.Settings = {{"//x/@y", "1=2"}, {"", ""}};
  const std::string request = EncodeRequest(sent);
  CHECK(DecodeRequest(request).Settings[0].Value == "1=2");
  CHECK(DecodeRequest(request).Folder == "/a b");
  for (size_t size = 0; size < result.size(); ++size) {
    CHECK_THROWS_AS(DecodeResult(std::string_view(result).substr(0, size)), CARGoSException);
  }
  for (size_t size = 0; size < request.size(); ++size) {
    CHECK_THROWS_AS(DecodeRequest(std::string_view(request).substr(0, size)), CARGoSException);
  }
  CHECK_THROWS_AS(DecodeResult(result + "x"), CARGoSException);
  CHECK_THROWS_AS(DecodeRequest(request + "x"), CARGoSException);
}

TEST_CASE("messages: a changed byte is an error or another result", "[campaign][messages]") {
  const std::string bytes = EncodeResult(42, MakeResult());
  for (size_t i = 0; i < bytes.size(); ++i) {
    for (const char flip : {char(0x01), char(0x80), char(0xff)}) {
      std::string changed = bytes;
      changed[i] = static_cast<char>(changed[i] ^ flip);
      try {
        const auto [id, result] = DecodeResult(changed);
        CHECK(EncodeResult(id, result).size() <= changed.size());
      } catch (const CARGoSException&) {
        SUCCEED();
      }
    }
  }
}

TEST_CASE("messages: a pipe carries any sizes in any pieces", "[campaign][messages]") {
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  const std::vector<std::string> bodies = {"", "x", std::string(1 << 20, 'y'), "end"};
  std::thread writer([&] {
    for (const std::string& body : bodies) {
      WriteMessage(ends[1], SMessage::EKind::Result, body);
    }
    close(ends[1]);
  });
  CMessageReader reader;
  std::vector<std::string> received;
  bool isOpen = true;
  while (isOpen) {
    isOpen = reader.Fill(ends[0]);
    while (const auto message = reader.Take()) {
      CHECK(message->Kind == SMessage::EKind::Result);
      received.push_back(message->Body);
    }
  }
  writer.join();
  close(ends[0]);
  CHECK(received == bodies);
}

TEST_CASE("messages: other bytes in a pipe are an error", "[campaign][messages]") {
  // magic, version, kind, and a size above 1 GiB are wrong
  const std::string bytes =
      GENERATE(std::string("hello world"), std::string("AX\x01\x02\0\0\0\0", 8),
               std::string("AC\x02\x02\0\0\0\0", 8), std::string("AC\x01\x00\0\0\0\0", 8),
               std::string("AC\x01\x04\0\0\0\0", 8), std::string("AC\x01\x02\x01\0\0\x40", 8));
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  REQUIRE(write(ends[1], bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()));
  CMessageReader reader;
  REQUIRE(reader.Fill(ends[0]));
  CHECK_THROWS_AS(reader.Take(), CARGoSException);
  close(ends[0]);
  close(ends[1]);
}

TEST_CASE("output tail: a limit that is reached exactly drops nothing", "[campaign][output_tail]") {
  COutputTail tail(10);
  tail.Add("0123456789");
  CHECK(tail.GetText() == "0123456789");
  // what is beyond is kept while it is little, so that a message after the limit can be read
  tail.Add("ab");
  CHECK(tail.GetText() == "0123456789ab");
}

TEST_CASE("output tail: keeps the end, within the limit and beyond", "[campaign][output_tail]") {
  COutputTail tail(100'000);
  std::string all;
  for (int i = 0; all.size() < 300'000; ++i) {
    const std::string line = "line " + std::to_string(i) + "\n";
    tail.Add(line);
    all += line;
    if (all.size() <= 100'000) {
      const size_t kept = std::min(all.size(), COutputTail::kSize);
      REQUIRE(tail.GetText() == all.substr(all.size() - kept));
    }
  }
  CHECK(tail.GetNumBytes() == all.size());
  const std::string text = tail.GetText();
  const size_t before = COutputTail::kSize - COutputTail::kSizeBeyond;
  CHECK(text.substr(0, before) == all.substr(100'000 - before, before));
  CHECK(text.substr(text.size() - COutputTail::kSizeBeyond) ==
        all.substr(all.size() - COutputTail::kSizeBeyond));
  const size_t dropped = all.size() - 100'000 - COutputTail::kSizeBeyond;
  CHECK_THAT(text, Catch::Contains("[... " + std::to_string(dropped) +
                                   " bytes beyond the limit of 100000 were dropped ...]"));
}

}  // namespace campaign_messages_test
