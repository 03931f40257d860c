// The commands, files and listings of doc/campaigns.md work, and so do all campaign files of
// experiments/.

#include "../command_line/program_run.h"

#include <argos3/campaign/design/campaign.h>
#include <argos3/support/child_process.h>
#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace campaign_page_test {

using namespace argos;
using Catch::Contains;

namespace {

/* A block between lines with three backquotes. */
struct SBlock {
  std::string Kind; /**< what follows the first backquotes, such as "sh" */
  std::string Text;
  int Line = 0; /**< of the first backquotes */
};

std::vector<SBlock> ReadBlocks(const std::string& path) {
  std::ifstream file(path);
  REQUIRE(file.good());
  std::vector<SBlock> blocks;
  bool isInside = false;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (line.rfind("```", 0) == 0) {
      isInside = !isInside;
      if (isInside) {
        blocks.push_back({line.substr(3), "", number});
      }
    } else if (isInside) {
      blocks.back().Text += line + '\n';
    }
  }
  REQUIRE_FALSE(isInside);
  return blocks;
}

// by a shell, in the folder; a failed command ends it. @return output and errors
std::string RunCommands(const CTestFolder& folder, const std::string& commands, int& status) {
  folder.Write("commands.sh", "set -eu\n. '" + InBuildTree("setup_env.sh") + "'\ncd '" +
                                  folder.Path(".") + "'\n" + commands);
  status = std::system(("bash '" + folder.Path("commands.sh") + "' > '" + folder.Path("out.txt") +
                        "' 2>&1 < /dev/null")
                           .c_str());
  return folder.Read("out.txt");
}

// blanks at the ends of lines do not count
void CheckListing(const std::string& listing, const std::string& output) {
  std::istringstream lines(listing);
  for (std::string line; std::getline(lines, line);) {
    CHECK_THAT(output, Contains(line));
  }
}

// false, with a message, if programs of other projects are missing
bool HasPrograms(const SBlock& block) {
  for (const char* program : {"sqlite3", "Rscript", "octave"}) {
    if (block.Text.find(program) != std::string::npos && FindProgram(program).empty()) {
      WARN("skipped: doc/campaigns.md:" << block.Line << ": " << program << " is not installed");
      return false;
    }
  }
  return true;
}

}  // namespace

/*
 * Blocks "sh" are executed, one after the other, in one folder; each line of a block "text" that
 * follows must be in the output. Blocks "console" are not executed. Blocks "xml" that are whole
 * campaign files are read.
 */
TEST_CASE("campaign page: its commands work, and print what it says", "[campaign][page]") {
  const CTestFolder folder;
  setenv("ARGOS_SOURCES", InSourceTree(".").c_str(), 1);
  std::string output;
  size_t numCommands = 0;
  size_t numListings = 0;
  for (const SBlock& block : ReadBlocks(InSourceTree("doc/campaigns.md"))) {
    INFO("doc/campaigns.md:" << block.Line << '\n' << block.Text);
    if (block.Kind == "sh") {
      output.clear();
      if (HasPrograms(block)) {
        int status = -1;
        output = RunCommands(folder, block.Text, status);
        INFO(output);
        REQUIRE(status == 0);
        ++numCommands;
      }
    } else if (block.Kind == "text" && !output.empty()) {
      INFO(output);
      CheckListing(block.Text, output);
      ++numListings;
    } else if (block.Kind == "xml" && block.Text.rfind("<argos-campaign", 0) == 0) {
      CHECK_NOTHROW(ReadCampaign(folder.Write("block.xml", block.Text)));
    }
  }
  CHECK(numCommands >= 5);
  CHECK(numListings >= 2);
}

TEST_CASE("campaign files of experiments/ can be run", "[campaign][page]") {
  size_t count = 0;
  const CTestFolder folder;
  for (const auto& entry :
       std::filesystem::directory_iterator(InSourceTree("experiments/campaigns"))) {
    if (entry.path().extension() != ".xml") {
      continue;
    }
    CAPTURE(entry.path());
    const SProgramRun run =
        folder.RunProgram("argos3-campaign", {"run", entry.path().string(), "--dry-run"});
    CHECK(run.Status == 0);
    CHECK(run.Err.empty());
    CHECK_THAT(run.Out, Contains(" combinations, ") && Contains(" to be executed\n"));
    ++count;
  }
  CHECK(count >= 1);
}

}  // namespace campaign_page_test
