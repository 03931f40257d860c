#include <argos3/program/catalogue/version_text.h>

#include <argos3/core/config.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/program/catalogue/public_headers.h>

#include <fstream>

namespace argos {

namespace {

std::string DescribeCompiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

// lines that the build has written: the commit and the build type
std::string ReadBuildFile() {
  std::ifstream file(FindInstallation() + "/share/argos3/build.txt");
  std::string text;
  for (std::string line; std::getline(file, line);) {
    text += line + '\n';
  }
  return text.empty() ? "ARGOS_COMMIT=unknown\nARGOS_BUILD_TYPE=unknown\n" : text;
}

// nothing if no engine is loaded
std::string DescribeEngines() {
  std::string line;
  for (const std::string& label : CFactory<CPhysicsEngine>::GetLabels()) {
    line += (line.empty() ? "\nARGOS_ENGINES=" : ",") + label;
  }
  return line;
}

}  // namespace

std::string DescribeVersion() {
#ifdef ARGOS_USE_DOUBLE
  constexpr char kUseDouble[] = "ON";
#else
  constexpr char kUseDouble[] = "OFF";
#endif
#ifdef ARGOS_THREADSAFE_LOG
  constexpr char kThreadSafeLog[] = "ON";
#else
  constexpr char kThreadSafeLog[] = "OFF";
#endif
#ifdef ARGOS_CHECK_INVARIANTS
  constexpr char kCheckInvariants[] = "ON";
#else
  constexpr char kCheckInvariants[] = "OFF";
#endif
  return std::string("ARGOS_VERSION=") + ARGOS_VERSION + "-" + ARGOS_RELEASE + '\n' +
         ReadBuildFile() + "ARGOS_COMPILER=" + DescribeCompiler() +
         "\nARGOS_BUILD_FLAGS=" + ARGOS_BUILD_FLAGS + "\nARGOS_USE_DOUBLE=" + kUseDouble +
         "\nARGOS_WITH_LUA=ON\nARGOS_THREADSAFE_LOG=" + kThreadSafeLog +
         "\nARGOS_CHECK_INVARIANTS=" + kCheckInvariants + DescribeEngines() +
         "\nARGOS_INSTALL_PREFIX=" + FindInstallation() + "\n";
}

}  // namespace argos
