#include <argos3/plugins/simulator/visualizations/live/run/page.h>

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

extern char** environ;

namespace argos {

namespace {

constexpr char kNoPage[] = R"(<!DOCTYPE html>
<html lang="en">
<head><meta charset="utf-8"><title>ARGoS live view</title></head>
<body>
<h1>The page of the live view was not built</h1>
<p>The run is served here, but the page that shows it is missing: npm was not found when the
simulator was built. <code>scripts/run.sh EXPERIMENT --live</code> installs it and builds the page
(Debian: <code>apt-get install nodejs npm</code>, then configure and build again).</p>
</body>
</html>
)";

bool HasVariable(const char* name) {
  const char* const value = std::getenv(name);
  return value != nullptr && *value != '\0';
}

}  // namespace

std::string ReadPage(const std::string& prefix) {
  std::ifstream file(prefix + "/share/argos3/live/index.html", std::ios::binary);
  std::string page((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  return page.empty() ? kNoPage : page;
}

void OpenPage(const std::string& url) {
  if (!HasVariable("DISPLAY") && !HasVariable("WAYLAND_DISPLAY")) {
    return;
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
  }
  std::string program = "xdg-open";
  std::string argument = url;
  char* arguments[] = {program.data(), argument.data(), nullptr};
  pid_t child = 0;
  static_cast<void>(posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments, environ));
  posix_spawn_file_actions_destroy(&actions);
}

}  // namespace argos
