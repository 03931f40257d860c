#include <argos3/core/utility/math/random_stream.h>
#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/media/rab_routing.h>
#include <argos3/testing/support/no_allocation.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <vector>

namespace rab_routing_test {

using namespace argos;

namespace {

const CRange<CVector3> kArena(CVector3(-5.0, -5.0, 0.0), CVector3(5.0, 5.0, 2.0));

// devices with ranges of several orders of magnitude and two message sizes, in and around the arena
void Fill(CRABRouting::SDevices& devices, size_t num, UInt64 seed) {
  CRandomStream random(seed, "test", "rab routing", "devices");
  const Real ranges[] = {0.0, 0.1, 0.8, 0.8, 0.8, 3.0, 100.0};
  devices.Resize(num);
  for (size_t i = 0; i < num; ++i) {
    devices.X[i] = random.Uniform(-6.0, 6.0);
    devices.Y[i] = random.Uniform(-6.0, 6.0);
    devices.Z[i] = random.Uniform(0.0, 0.5);
    devices.Range[i] = ranges[random.UniformInteger(UInt64(7))];
    devices.MessageSize[i] = random.Bernoulli(0.8) ? 10 : 2;
    devices.Bodies[i] = {nullptr, 0};
  }
}

std::vector<std::vector<UInt32>> ByBruteForce(const CRABRouting::SDevices& devices) {
  std::vector<std::vector<UInt32>> heard(devices.GetSize());
  for (size_t receiver = 0; receiver < heard.size(); ++receiver) {
    for (size_t sender = 0; sender < heard.size(); ++sender) {
      const Real distance =
          Distance(CVector3(devices.X[sender], devices.Y[sender], devices.Z[sender]),
                   CVector3(devices.X[receiver], devices.Y[receiver], devices.Z[receiver]));
      if (sender != receiver && devices.MessageSize[sender] == devices.MessageSize[receiver] &&
          distance < devices.Range[sender]) {
        heard[receiver].push_back(static_cast<UInt32>(sender));
      }
    }
  }
  return heard;
}

std::vector<std::vector<UInt32>> Heard(const CRABRouting& routing, size_t num) {
  std::vector<std::vector<UInt32>> heard;
  for (UInt32 device = 0; device < num; ++device) {
    const CRABRouting::SNumbers senders = routing.GetSenders(device);
    heard.emplace_back(senders.begin(), senders.end());
  }
  return heard;
}

}  // namespace

TEST_CASE("rab routing: devices in range receive, for any index and number of threads", "[media]") {
  const auto kind =
      GENERATE(SIndexChoice::EKind::Grid, SIndexChoice::EKind::Hash, SIndexChoice::EKind::Dummy);
  const UInt32 threads = GENERATE(0U, 1U, 4U);
  const std::string method = GENERATE("balance_quantity", "balance_length");
  CAPTURE(static_cast<int>(kind), threads, method);
  CThreadPool pool(threads, CreateSchedule(method));
  SIndexChoice options;
  options.Kind = kind;
  CRABRouting routing;
  routing.SetOptions(options, kArena);
  for (const size_t num : {0, 1, 400, 50}) {
    Fill(routing.GetDevices(), num, num);
    routing.Route(pool, nullptr);
    CHECK(Heard(routing, num) == ByBruteForce(routing.GetDevices()));
  }
  routing.Clear();
  CHECK(routing.GetSenders(0).size() == 0);
}

TEST_CASE("rab routing: the range is exclusive, and only that of the sender counts", "[media]") {
  CThreadPool pool(0, CreateSchedule("balance_quantity"));
  CRABRouting routing;
  routing.SetOptions(SIndexChoice(), kArena);
  CRABRouting::SDevices& devices = routing.GetDevices();
  devices.Resize(3);
  // distances 1 and 2 along x are exact
  devices.X = {0.0, 1.0, 2.0};
  devices.Y = devices.Z = {0.0, 0.0, 0.0};
  devices.Range = {2.0, 1.0, 1.5};
  devices.MessageSize = {4, 4, 4};
  devices.Reach.assign(3, 0.0);
  devices.Bodies.assign(3, {nullptr, 0});
  routing.Route(pool, nullptr);
  const std::vector<std::vector<UInt32>> expected = {{}, {0, 2}, {}};
  CHECK(Heard(routing, 3) == expected);
}

TEST_CASE("rab routing: devices of one range hear each other, but not at that distance",
          "[media]") {
  CThreadPool pool(0, CreateSchedule("balance_quantity"));
  CRABRouting routing;
  routing.SetOptions(SIndexChoice(), kArena);
  CRABRouting::SDevices& devices = routing.GetDevices();
  Fill(devices, 300, 3);
  devices.Range.assign(300, 0.8);
  // exactly 0.5 apart along each axis, and of another size
  devices.Resize(304);
  for (size_t i = 300; i < 304; ++i) {
    devices.X[i] = i == 301 ? 8.5 : 8.0;
    devices.Y[i] = i == 302 ? 8.5 : 8.0;
    devices.Z[i] = i == 303 ? 0.5 : 0.0;
    devices.Range[i] = 0.8;
    devices.MessageSize[i] = 10;
  }
  routing.Route(pool, nullptr);
  CHECK(Heard(routing, 304) == ByBruteForce(devices));
  devices.Range.assign(304, 0.5);
  routing.Route(pool, nullptr);
  CHECK(Heard(routing, 304) == ByBruteForce(devices));
  CHECK(routing.GetSenders(300).size() == 0);
}

TEST_CASE("rab routing: devices at NaN or infinity neither receive nor are received", "[media]") {
  CThreadPool pool(0, CreateSchedule("balance_quantity"));
  CRABRouting routing;
  routing.SetOptions(SIndexChoice(), kArena);
  Fill(routing.GetDevices(), 20, 1);
  CRABRouting::SDevices& devices = routing.GetDevices();
  devices.Range.assign(20, 100.0);
  devices.MessageSize.assign(20, 1);
  devices.X[3] = std::numeric_limits<Real>::quiet_NaN();
  devices.Z[5] = std::numeric_limits<Real>::infinity();
  routing.Route(pool, nullptr);
  for (UInt32 device = 0; device < 20; ++device) {
    CHECK(routing.GetSenders(device).size() == (device == 3 || device == 5 ? 0 : 17));
  }
}

TEST_CASE("rab routing: a call in steady state allocates nothing", "[media][allocation]") {
  const UInt32 threads = GENERATE(0U, 2U);
  const std::string method = GENERATE("balance_quantity", "balance_length");
  CThreadPool pool(threads, CreateSchedule(method));
  CRABRouting routing;
  routing.SetOptions(SIndexChoice(), kArena);
  Fill(routing.GetDevices(), 300, 1);
  routing.Route(pool, nullptr);
  // other positions with about as many pairs
  Fill(routing.GetDevices(), 300, 2);
  CheckAllocatesNothing([&] { routing.Route(pool, nullptr); });
}

}  // namespace rab_routing_test
