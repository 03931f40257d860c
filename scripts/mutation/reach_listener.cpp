// scripts/mutate.sh adds this to test programs: appends a line for each test case to the file that
// ARGOS_MUTATION_CASES names: passed or failed, seconds, the mutants it reached (a byte each: see
// reach.h), its name.

// Catch2 declares listeners only on demand
#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include <catch2/catch.hpp>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

namespace argos_mutation {

class CReachListener : public Catch::TestEventListenerBase {
 public:
  using TestEventListenerBase::TestEventListenerBase;

  void testCaseStarting(const Catch::TestCaseInfo& info) override {
    TestEventListenerBase::testCaseStarting(info);
    if (m_cases == nullptr || m_map == nullptr) {
      return;
    }
    const std::string map = ReadMap();
    // in place: processes have it mapped
    std::fstream(m_map, std::ios::in | std::ios::out) << std::string(map.size(), '0');
    m_begin = std::chrono::steady_clock::now();
  }

  void testCaseEnded(const Catch::TestCaseStats& stats) override {
    if (m_cases != nullptr && m_map != nullptr) {
      const std::chrono::duration<double> time = std::chrono::steady_clock::now() - m_begin;
      std::ofstream(m_cases, std::ios::app)
          << (stats.totals.assertions.allOk() ? "passed " : "failed ") << time.count() << ' '
          << ReadMap() << ' ' << stats.testInfo.name << '\n';
    }
    TestEventListenerBase::testCaseEnded(stats);
  }

 private:
  std::string ReadMap() const {
    std::ifstream file(m_map);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  const char* m_cases = std::getenv("ARGOS_MUTATION_CASES");
  const char* m_map = std::getenv("ARGOS_MUTATION_MAP");
  std::chrono::steady_clock::time_point m_begin;
};

CATCH_REGISTER_LISTENER(CReachListener)

}  // namespace argos_mutation
