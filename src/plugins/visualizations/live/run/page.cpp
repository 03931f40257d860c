#include <argos3/plugins/simulator/visualizations/live/run/page.h>

#include <fstream>
#include <iterator>

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

std::string ReadFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace

SLivePage ReadPage(const std::string& prefix) {
  const std::string path = prefix + "/share/argos3/live/index.html";
  SLivePage page{ReadFile(path), ReadFile(path + ".gz")};
  if (page.Text.empty()) {
    page = {kNoPage, ""};
  }
  return page;
}

}  // namespace argos
