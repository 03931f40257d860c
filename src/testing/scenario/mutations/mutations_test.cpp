// Mutated experiment files: each loads and runs, or gives an error with file and line.

#include "../command_line/program_run.h"
#include "case_runner.h"
#include "mutators.h"
#include "xml_tree.h"

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

namespace mutations_test {

using namespace argos;
namespace fs = std::filesystem;

namespace {

/* of the reference files of compat/reference_file_test.cpp */
class CReferenceController : public CCI_Controller {
 public:
  void Init(TConfigurationNode& params) override {
    Real parameter = 0.0;
    for (const char* const name : {"alpha", "delta", "velocity"}) {
      GetNodeAttributeOrDefault(params, name, parameter, 0.0);
    }
  }
};

REGISTER_CONTROLLER(CReferenceController, "reference_controller")

std::string ReadFile(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// what is between two texts, without them
std::string Between(const std::string& text, const std::string& begin, const std::string& end,
                    std::size_t from = 0) {
  const std::size_t first = text.find(begin, from);
  if (first == std::string::npos) {
    return "";
  }
  const std::size_t start = first + begin.size();
  return text.substr(start, text.find(end, start) - start);
}

// the files in the source of the tests of compatibility
std::vector<std::string> ReferenceFiles() {
  const std::string source = ReadFile(InSourceTree("src/testing/compat/reference_file_test.cpp"));
  const std::string footbot = Between(source, "kFootBotController = R\"(", ")\"");
  const std::string epuck = Between(source, "kEPuckController = R\"(", ")\"");
  const std::string begin = "<argos-configuration>";
  const std::string end = "</argos-configuration>";
  std::vector<std::string> files;
  for (std::size_t at = source.find(begin); at != std::string::npos;
       at = source.find(begin, at + 1)) {
    std::string file = begin + Between(source, begin, end, at) + end;
    Replace(file, "$FOLDER", ".");
    Replace(file, "$FOOTBOT", footbot);
    Replace(file, "$EPUCK", epuck);
    files.push_back(file);
  }
  return files;
}

// small swarms, so that a case takes a few milliseconds
std::string WithFewRobots(const std::string& xml) {
  constexpr int kMaxRobots = 6;
  const std::unique_ptr<SXmlElement> root = ParseXml(xml);
  for (const SXmlPlace& place : ListElements(*root)) {
    for (auto& [name, value] : place.Element->Attributes) {
      if (name == "quantity" && std::atoi(value.c_str()) > kMaxRobots) {
        value = std::to_string(kMaxRobots);
      }
    }
  }
  return ToText(*root);
}

std::vector<std::string> BaseFiles() {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(InSourceTree("experiments"))) {
    if (entry.path().extension() == ".argos") {
      paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> files;
  for (const fs::path& path : paths) {
    files.push_back(WithFewRobots(ReadFile(path)));
  }
  for (const std::string& file : ReferenceFiles()) {
    files.push_back(WithFewRobots(file));
  }
  return files;
}

/* Runs cases and counts their outcomes. */
class CCampaign {
 public:
  explicit CCampaign(std::uint64_t seed) : m_seed(seed), m_files(BaseFiles()) {
    setenv("ARGOS_PLUGIN_PATH", InBuildTree("experiments").c_str(), 1);
    // as seen from the files of the experiments, and from the root of the source tree
    fs::create_directory_symlink(InSourceTree("experiments"), m_folder.Path("experiments"));
    for (const char* const folder : {"controllers", "loop_functions"}) {
      fs::create_directory_symlink(InSourceTree(std::string("experiments/") + folder),
                                   m_folder.Path(folder));
    }
    m_folder.Write("floor.ppm", "P3\n2 2\n255\n255 255 255 0 0 0 0 0 0 255 255 255\n");
  }

  std::size_t GetNumFiles() const { return m_files.size(); }
  const std::string& GetFile(std::size_t number) const { return m_files[number]; }
  std::string GetFolder() const { return m_folder.Path("."); }

  std::string GetCase(EMutation mutation, std::size_t number, std::string& description) const {
    return Mutate(m_files[number % m_files.size()], mutation, SeedOf(number), description);
  }

  /* Prints the failures, and returns their number. */
  std::size_t Run(EMutation mutation, const char* name, std::size_t number) const {
    const std::vector<SCaseResult> results = RunCases(
        number,
        [&](std::size_t i) {
          std::string description;
          return GetCase(mutation, i, description);
        },
        GetFolder());
    std::ostringstream report;
    std::map<EOutcome, std::size_t> counts;
    std::size_t failures = 0;
    for (std::size_t i = 0; i < results.size(); ++i) {
      ++counts[results[i].Outcome];
      const bool isAccepted = IsAccepted(results[i].Outcome);
      failures += isAccepted ? 0 : 1;
      if (!isAccepted || results[i].Outcome == EOutcome::ErrorWithoutPlace) {
        std::string description;
        GetCase(mutation, i, description);
        report << name << " case " << i << " of file " << i % m_files.size() << ", seed " << m_seed
               << ": " << ToText(results[i].Outcome) << "\n  " << description << "\n  "
               << results[i].Text << '\n';
      }
    }
    report << number << ' ' << name << " mutations of " << m_files.size() << " files, seed "
           << m_seed << ':';
    for (const auto& [outcome, count] : counts) {
      report << ' ' << count << ' ' << ToText(outcome) << ',';
    }
    report << " failures: " << failures << '\n';
    // std::cout belongs to the log, which is captured
    std::fputs(report.str().c_str(), stdout);
    m_withoutPlace += counts[EOutcome::ErrorWithoutPlace];
    return failures;
  }

  std::size_t GetNumWithoutPlace() const { return m_withoutPlace; }

 private:
  std::uint64_t SeedOf(std::size_t number) const { return m_seed * 1000000007 + number; }

  std::uint64_t m_seed;
  std::vector<std::string> m_files;
  CTestFolder m_folder;
  mutable std::size_t m_withoutPlace = 0;
};

void CheckMutations(std::uint64_t seed, std::size_t cases) {
  const CCampaign campaign(seed);
  CAPTURE(seed);
  // most errors of users are in values
  const std::size_t attributes = cases * 3 / 5;
  const std::size_t elements = cases / 4;
  std::size_t failures = campaign.Run(EMutation::Attribute, "attribute", attributes);
  failures += campaign.Run(EMutation::Element, "element", elements);
  failures += campaign.Run(EMutation::File, "file", cases - attributes - elements);
  CHECK(failures == 0);
  // 99.9 % of all cases
  CHECK(campaign.GetNumWithoutPlace() * 1000 <= cases);
}

}  // namespace

TEST_CASE("mutations: the files load without mutation", "[mutations]") {
  const CCampaign campaign(1);
  REQUIRE(campaign.GetNumFiles() > 30);
  const std::vector<SCaseResult> results = RunCases(
      campaign.GetNumFiles(), [&](std::size_t i) { return campaign.GetFile(i); },
      campaign.GetFolder());
  for (std::size_t i = 0; i < results.size(); ++i) {
    CAPTURE(i, results[i].Text);
    CHECK(ToText(results[i].Outcome) == std::string("loaded"));
  }
}

TEST_CASE("mutations: a crash, an endless case and a huge one are noticed", "[mutations]") {
  const CTestFolder folder;
  const auto crash = [](std::size_t number) -> std::string {
    if (number == 1) {
      std::abort();
    }
    if (number == 2) {
      for (volatile bool endless = true; endless;) {
      }
    }
    return "<no-experiment/>";
  };
  const std::vector<SCaseResult> results =
      RunCases(4, crash, folder.Path("."), SCaseLimits{.Seconds = 1});
  CHECK(ToText(results[0].Outcome) == std::string("error with file and line"));
  CHECK(ToText(results[1].Outcome) == std::string("crash"));
  CHECK(ToText(results[2].Outcome) == std::string("timeout"));
  CHECK(ToText(results[3].Outcome) == std::string("error with file and line"));
}

TEST_CASE("mutations: 2000 mutated files load, or give an error with file and line",
          "[mutations]") {
  CheckMutations(1, 2000);
}

// the seed of another run: MUTATION_SEED=7 scenario_input_tests "[mutations][soak]"
TEST_CASE("mutations: 20000 mutated files load, or give an error with file and line",
          "[.][soak][mutations]") {
  const char* const seed = std::getenv("MUTATION_SEED");
  CheckMutations(seed != nullptr ? std::strtoull(seed, nullptr, 10) : 2, 20000);
}

}  // namespace mutations_test
