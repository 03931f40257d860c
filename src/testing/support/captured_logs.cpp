#include <argos3/testing/support/captured_logs.h>

#include <argos3/core/utility/logging/argos_log.h>

// Catch2 declares listeners only on demand
#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include <catch2/catch.hpp>

#include <cstdlib>
#include <iostream>
#include <sstream>

namespace argos {

namespace {

constexpr int kUnexpectedErrors = 4;  // exit status

/** Replaces the buffer of a log's stream. */
class CCapture {
 public:
  explicit CCapture(CARGoSLog& log) : m_log(log) {}

  void Start() {
    m_log.DisableColoredOutput();
    m_log.Flush();
    m_text.str("");
    m_original = m_log.GetStream().rdbuf(&m_text);
  }
  void Stop() {
    m_log.Flush();
    m_log.GetStream().rdbuf(m_original);
  }
  std::string Take() {
    m_log.Flush();
    std::string text = m_text.str();
    m_text.str("");
    return text;
  }

 private:
  CARGoSLog& m_log;
  std::stringbuf m_text;
  std::streambuf* m_original = nullptr;
};

CCapture& Log() {
  static CCapture capture(LOG);
  return capture;
}

CCapture& LogErr() {
  static CCapture capture(LOGERR);
  return capture;
}

// Without lines about the run (CLogControl::Notify()). Tests place bodies where it suits them;
// scenario/bad_input tests the warning about such bodies.
std::string WithoutExpectedLines(const std::string& text) {
  std::istringstream lines(text);
  std::string kept;
  for (std::string line; std::getline(lines, line);) {
    const bool isOfPlace = line.find(" outside of the arena, from ") != std::string::npos ||
                           (line.find(" overlaps \"") != std::string::npos &&
                            line.find(" at the start") != std::string::npos);
    if (!isOfPlace && line.rfind("[INFO] ", 0) != 0) {
      kept += line + '\n';
    }
  }
  return kept;
}

class CListener : public Catch::TestEventListenerBase {
 public:
  using TestEventListenerBase::TestEventListenerBase;

  void testCaseStarting(const Catch::TestCaseInfo& test) override {
    m_test = test.name;
    Log().Start();
    LogErr().Start();
  }
  void testCaseEnded(const Catch::TestCaseStats&) override {
    const std::string errors = TakeLogErr();
    Log().Stop();
    LogErr().Stop();
    if (!errors.empty()) {
      std::cerr << "unexpected in the error log of \"" << m_test << "\":\n" << errors;
      static const int registered = std::atexit([] { std::_Exit(kUnexpectedErrors); });
      static_cast<void>(registered);
    }
  }

 private:
  std::string m_test;
};

}  // namespace

std::string TakeLog() {
  return Log().Take();
}

std::string TakeLogErr() {
  return WithoutExpectedLines(LogErr().Take());
}

CATCH_REGISTER_LISTENER(CListener)

}  // namespace argos
