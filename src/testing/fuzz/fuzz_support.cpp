#include <argos3/testing/fuzz/fuzz_support.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/logging/argos_log.h>

#include <iostream>
#include <streambuf>

namespace argos {

namespace {

/** Takes every text and keeps none. */
class CNoText : public std::streambuf {
 protected:
  int overflow(int c) override { return c == traits_type::eof() ? 0 : c; }
  std::streamsize xsputn(const char*, std::streamsize count) override { return count; }
};

}  // namespace

int RunFuzzInput(const std::function<void()>& body) {
  static CNoText noText;
  std::cout.rdbuf(&noText);
  std::cerr.rdbuf(&noText);
  try {
    body();
  } catch (const CARGoSException&) {
    // a message, as it should be
  }
  LOG.Flush();
  LOGERR.Flush();
  return 0;
}

}  // namespace argos
