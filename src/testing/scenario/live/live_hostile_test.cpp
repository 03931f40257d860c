// Clients of the live view that attack it: the run and its memory must not notice.

#include "live_viewer.h"
#include "raw_client.h"

#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace live_hostile_test {

using namespace argos;
using Catch::Contains;

namespace {

constexpr size_t kMaxGrowth = size_t(96) << 20;  // bytes, of the process with all its clients

// resident, bytes
size_t GetMemory() {
  std::ifstream file("/proc/self/statm");
  size_t size = 0;
  size_t resident = 0;
  file >> size >> resident;
  return resident * static_cast<size_t>(sysconf(_SC_PAGESIZE));
}

/* Makes messages and frames that are nearly right. */
class CFuzzer {
 public:
  explicit CFuzzer(UInt32 seed) : m_random(seed) {}

  UInt32 Draw(UInt32 count) { return static_cast<UInt32>(m_random() % count); }

  TJson MakeValue(int depth = 0) {
    switch (Draw(depth < 4 ? 12 : 9)) {
      case 0:
        return -1;
      case 1:
        return 1e308;
      case 2:
        return ~UInt64(0);
      case 3:
        return "fb" + std::to_string(Draw(12));
      case 4:
        return nullptr;
      case 5:
        return Draw(2) == 0;
      case 6:
        return std::string(Draw(300), static_cast<char>('!' + Draw(90)));
      case 7:
        return 0.001 * Draw(4000) - 2.0;
      case 8:
        return Draw(50);
      case 9:
        return TJson({MakeValue(depth + 1), MakeValue(depth + 1), MakeValue(depth + 1)});
      case 10:
        return TJson({{"x", MakeValue(depth + 1)}});
      default:
        return TJson({0.1 * Draw(40) - 2.0, 0.1 * Draw(40) - 2.0, 0});
    }
  }

  TJson MakeCommand() {
    static const char* const names[] = {
        "play",        "pause",  "step",       "speed",         "reset",       "redistribute",
        "seek",        "move",   "add",        "remove",        "drive",       "user_select",
        "user_key",    "pin",    "unpin",      "rate",          "ask_control", "give_control",
        "open_script", "script", "parameters", "set_parameter", "pinned",      "",
        "fly"};
    static const char* const arguments[] = {
        "n",      "factor", "seed",   "tick",   "entity", "position", "yaw",     "type", "movable",
        "mass",   "size",   "radius", "height", "left",   "right",    "key",     "down", "fps",
        "viewer", "text",   "name",   "value",  "all",    "ack",      "entities"};
    TJson command = {{"do", names[Draw(std::size(names))]}, {"id", Draw(1000)}};
    for (UInt32 left = Draw(5); left > 0; --left) {
      command[arguments[Draw(std::size(arguments))]] = MakeValue();
    }
    if (Draw(8) == 0) {
      command[Draw(2) == 0 ? "do" : "id"] = MakeValue();
    }
    return command;
  }

  std::string MakeFuzzedFrame() {
    std::string payload = MakeCommand().dump(-1, ' ', false, TJson::error_handler_t::replace);
    if (Draw(10) == 0) {
      for (UInt32 left = 1 + Draw(4); left > 0 && !payload.empty(); --left) {
        payload[Draw(static_cast<UInt32>(payload.size()))] = static_cast<char>(Draw(256));
      }
    }
    if (Draw(20) == 0) {
      payload.resize(Draw(static_cast<UInt32>(payload.size()) + 1));
    }
    SRawFrame frame;
    if (Draw(25) == 0) {
      frame.FirstByte = static_cast<UInt8>(Draw(256));
      frame.IsMasked = Draw(4) != 0;
      frame.ExtraLength = Draw(4) == 0 ? (SInt64(1) << Draw(62)) : 0;
    }
    return MakeFrame(payload, frame);
  }

 private:
  std::mt19937 m_random;
};

// by clients that do not have control
// @param before  bytes.
void CheckMemory(size_t before) {
  // AddressSanitizer keeps freed memory in its quarantine
  if (!kHasAddressSanitizer) {
    CHECK(GetMemory() < before + kMaxGrowth);
  }
}

void SendFuzzedFrames(const CLiveWorld& world, UInt32 count, UInt32 seed) {
  constexpr UInt32 kFramesPerClient = 80;
  CFuzzer fuzzer(seed);
  for (UInt32 sent = 0; sent < count; sent += kFramesPerClient) {
    CRawClient client(world.GetURL());
    client.Join();
    std::string bytes;
    for (UInt32 i = 0; i < kFramesPerClient; ++i) {
      bytes += fuzzer.MakeFuzzedFrame();
    }
    client.Send(bytes);
    client.IsClosedWithin(0.001);
  }
}

void CheckFuzzedFrames(UInt32 count) {
  const UInt64 expected = RunHeadless(Diffusion(20));
  CLiveWorld world(kWaits, Diffusion(20));
  auto viewer = Join(world);
  SendFuzzedFrames(world, 400, 1);
  const size_t before = GetMemory();
  SendFuzzedFrames(world, count, 2);
  CheckMemory(before);
  // it has lost nothing but time
  CHECK(viewer->GetStatus().value("tick", 0U) == 0);
  PlayToEnd(*viewer);
  CHECK(IsOk(viewer->Do("end")));
  CHECK(world.Finish() == expected);
}

// when the server has noticed that others have left
std::unique_ptr<CLiveClient> JoinSoon(const CLiveWorld& world) {
  for (int tries = 0; tries < 50; ++tries) {
    try {
      return Join(world);
    } catch (const std::exception&) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
  }
  return Join(world);
}

std::string GetHost(const CLiveWorld& world) {
  const std::string& url = world.GetURL();
  return url.substr(7, url.find("/#") - 7);
}

std::string Request(const CLiveWorld& world, const std::string& lines) {
  return RequestByHTTP(world.GetURL(), lines + "\r\n\r\n");
}

}  // namespace

TEST_CASE("hostile live view: 20,000 fuzzed frames change neither the run nor its memory",
          "[live]") {
  CheckFuzzedFrames(FewerIfSanitized(20000));
}

TEST_CASE("hostile live view: 1,000,000 fuzzed frames change neither the run nor its memory",
          "[.][soak][live]") {
  CheckFuzzedFrames(1000000);
}

TEST_CASE("hostile live view: no command of the viewer with control ends the run", "[live]") {
  CLiveWorld world({{"speed", "0"}, {"edit", "true"}}, Diffusion(2));
  auto viewer = Join(world);
  CFuzzer fuzzer(3);
  int numSent = 0;
  for (int i = 0; i < 1500; ++i) {
    TJson command = fuzzer.MakeCommand();
    const TJson name = command["do"];
    // those change who is asked, or how long this test takes
    if (!name.is_string() || name == "give_control" || name == "rate" || name == "speed") {
      continue;
    }
    if (++numSent % 90 == 0) {
      // 100 messages a second are allowed
      viewer = nullptr;
      viewer = Join(world);
    }
    const TJson answer = viewer->Do(name.get<std::string>(), command);
    CAPTURE(command.dump());
    REQUIRE(answer.is_object());
  }
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

TEST_CASE("hostile live view: floods do not keep the run from its ticks", "[live]") {
  const UInt64 expected = RunHeadless(Diffusion(20));
  CLiveWorld world(kWaits, Diffusion(20));
  auto viewer = Join(world);
  std::vector<std::thread> flooding;
  for (int i = 0; i < 4; ++i) {
    flooding.emplace_back([&world] {
      const std::string frame = MakeFrame(R"({"do":"pin","entity":"fb0","id":1})");
      std::string many;
      for (int copy = 0; copy < 500; ++copy) {
        many += frame;
      }
      for (int client = 0; client < 20; ++client) {
        CRawClient raw(world.GetURL());
        raw.Join();
        raw.Send(many);
        raw.Send(MakeFrame(std::string(70000, ' ')));
      }
    });
  }
  PlayToEnd(*viewer);
  for (std::thread& thread : flooding) {
    thread.join();
  }
  CHECK(IsOk(viewer->Do("end")));
  CHECK(world.Finish() == expected);
}

TEST_CASE("hostile live view: a thousand connections leave a viewer alone", "[live]") {
  rlimit limit{};
  getrlimit(RLIMIT_NOFILE, &limit);
  const rlimit before = limit;
  limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, 4096);
  setrlimit(RLIMIT_NOFILE, &limit);
  REQUIRE(limit.rlim_cur >= 2048);
  CLiveWorld world(kWaits, Diffusion(3));
  auto viewer = Join(world);
  const size_t memory = GetMemory();
  {
    std::vector<std::unique_ptr<CRawClient>> others;
    for (int i = 0; i < 1000; ++i) {
      others.push_back(std::make_unique<CRawClient>(world.GetURL()));
    }
    CHECK(IsOk(viewer->Do("step", {{"n", 3}})));
    viewer->ReceiveUntil([&] { return viewer->GetFrame().Tick == 3; });
    CheckMemory(memory);
    // what is beyond 256 is closed at once
    int numClosed = 0;
    for (size_t i = 900; i < others.size(); ++i) {
      numClosed += others[i]->IsClosedWithin(1.0) ? 1 : 0;
    }
    CHECK(numClosed == 100);
  }
  CHECK(IsOk(JoinSoon(world)->Do("pin", {{"entity", "fb0"}})));
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
  setrlimit(RLIMIT_NOFILE, &before);
}

TEST_CASE("hostile live view: connections that stop in the middle are closed", "[live]") {
  CLiveWorld world(kWaits, Diffusion(3));
  auto viewer = Join(world);
  std::vector<std::unique_ptr<CRawClient>> halves;
  const auto add = [&]() -> CRawClient& {
    halves.push_back(std::make_unique<CRawClient>(world.GetURL()));
    return *halves.back();
  };
  add();
  add().Send("GET / HT");
  add().Send("GET /live HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\n");
  add().ShakeHands();
  CRawClient& half = add();
  half.ShakeHands();
  half.Send(MakeFrame("{\"hello\":", {0x01, true, 0}));
  // 5 s for a request and for the token
  for (const auto& connection : halves) {
    CHECK(connection->IsClosedWithin(8.0));
  }
  CHECK(IsOk(viewer->Do("step")));
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

TEST_CASE("hostile live view: a viewer that acknowledges nothing gets two states", "[live]") {
  CLiveWorld world({{"speed", "0"}, {"fps", "100"}}, Diffusion(3));
  auto viewer = Join(world);
  CLiveClient silent(world.GetURL());
  silent.SetAcknowledges(false);
  silent.Hello();
  PlayToEnd(*viewer);
  // a short run may end before the second one has been sent
  silent.ReceiveUntil([&] { return silent.CountFrames() == 2; });
  CHECK(IsOk(silent.Do("pin", {{"entity", "fb0"}})));
  silent.WaitFor("values");
  CHECK(silent.CountFrames() == 2);
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

TEST_CASE("hostile live view: there is one page, whatever path is asked for", "[live]") {
  CLiveWorld world(kWaits, Diffusion(3));
  const std::string host = GetHost(world);
  for (const char* path : {"/../../../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "//etc/passwd",
                           "/..%2f..%2fetc%2fpasswd", "/live/../../etc/passwd", "/.ssh/id_rsa",
                           "/index.html/../../etc/passwd", "/?file=/etc/passwd",
                           "/diffusion_10.argos", "file:///etc/passwd"}) {
    CAPTURE(path);
    const std::string answer =
        Request(world, std::string("GET ") + path + " HTTP/1.1\r\nHost: " + host);
    CHECK_THAT(answer, !Contains("root:"));
    CHECK_THAT(answer, Contains("404"));
  }
  for (const char* name : {"evil.example", "127.0.0.1.evil.example", "localhost@evil.example",
                           "evil.example#localhost", "", "127.0.0.2", "[::1].evil.example",
                           "localhost:80:80", "localhost evil.example"}) {
    CAPTURE(name);
    const std::string answer = Request(world, std::string("GET / HTTP/1.1\r\nHost: ") + name);
    CHECK_THAT(answer, !Contains("200 OK"));
  }
  for (const char* origin : {"http://evil.example", "null", "file://", "http://localhost:1",
                             "https://127.0.0.1", "http://127.0.0.1:80@evil.example"}) {
    CAPTURE(origin);
    CHECK_THROWS(CLiveClient(world.GetURL(), CLiveClient::SOptions{.Origin = origin}));
  }
  const std::string longHeader = "GET / HTTP/1.1\r\nHost: " + host + "\r\nX: ";
  CHECK_THAT(Request(world, longHeader + std::string(20000, 'x')), !Contains("200 OK"));
  CHECK(IsOk(Join(world)->Do("end")));
  world.Finish();
}

}  // namespace live_hostile_test
