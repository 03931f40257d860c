// Libraries that are opened at the first look-up of one of their labels. Each test case works in a
// child process, because a library that is open stays open. Uses the libraries of
// src/testing/support/plugins in <build>/testing/plugins.

#include <argos3/core/utility/plugins/dynamic_loading.h>
#include <argos3/core/utility/plugins/elf_file.h>
#include <argos3/core/utility/plugins/label_index.h>

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/testing/support/forked.h>
#include <argos3/testing/support/paths.h>
#include <argos3/testing/support/temporary_folder.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace deferred_libraries_test {

using namespace argos;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

using TControllers = CFactory<CCI_Controller>;
using TEntities = CFactory<CEntity>;

const std::string kBuilt = InBuildTree("testing/plugins");

SPluginLabel Controller(const std::string& label) {
  return {typeid(CCI_Controller).name(), label};
}

// a folder that is the plug-in path of the process
class CPlugins {
 public:
  CPlugins() { setenv("ARGOS_PLUGIN_PATH", m_folder.GetPath().c_str(), 1); }
  ~CPlugins() { unsetenv("ARGOS_PLUGIN_PATH"); }

  // a copy of a library of the tests. @return its path
  std::string Add(const std::string& name) const {
    const std::string file = "lib" + name + ".so";
    fs::copy(kBuilt + '/' + file, m_folder.Path(file));
    return m_folder.Path(file);
  }
  // the same, with an index
  std::string AddWithIndex(const std::string& name, const std::vector<SPluginLabel>& labels) const {
    const std::string path = Add(name);
    WriteLabelIndex(path, labels);
    return path;
  }
  const CTemporaryFolder& Folder() const { return m_folder; }

 private:
  CTemporaryFolder m_folder;
};

// Whether a library is part of this process. Others of the process are not listed by path.
bool IsOpen(const std::string& path) {
  std::ifstream maps("/proc/self/maps");
  std::stringstream text;
  text << maps.rdbuf();
  return text.str().find(fs::canonical(path).string()) != std::string::npos;
}

// What a function tells, which runs in a child process after all libraries were made known, and the
// logs of that.
std::string InChild(const std::function<void(std::ostream&)>& function) {
  const CTemporaryFolder folder;
  const int status = CallInFork([&] {
    std::ofstream text(folder.Path("text"));
    LOG.Flush();
    LOGERR.Flush();
    LOG.GetStream().rdbuf(text.rdbuf());
    LOGERR.GetStream().rdbuf(text.rdbuf());
    try {
      CDynamicLoading::LoadAllLibrariesByLabel();
      function(text);
    } catch (const std::exception& error) {
      text << "threw: " << error.what() << std::endl;
    }
    LOG.Flush();
    LOGERR.Flush();
    text.flush();
    return 0;
  });
  CHECK(status == 0);
  return folder.Read("text");
}

const std::vector<SPluginLabel> kNumbered2 = {Controller("test_numbered_controller_2"),
                                              {typeid(CEntity).name(), "test-marker-2"}};

}  // namespace

TEST_CASE("deferred libraries: the first look-up of a label opens its library, and no other",
          "[core][plugins]") {
  const CPlugins plugins;
  const std::string wanted = plugins.AddWithIndex("argos3_test_numbered_2", kNumbered2);
  const std::string other =
      plugins.AddWithIndex("argos3_test_numbered_3", {Controller("test_numbered_controller_3")});
  const std::string facts = InChild([&](std::ostream& out) {
    const std::vector<std::string> labels = TControllers::GetLabels();
    out << std::count(labels.begin(), labels.end(), "test_numbered_controller_2") << ' '
        << IsOpen(wanted) << ' ' << TControllers::Exists("test_numbered_controller_4") << ' '
        << IsOpen(wanted) << ' ' << TEntities::Exists("test-marker-2") << ' ' << IsOpen(wanted)
        << ' ' << TControllers::Exists("test_numbered_controller_2") << ' ' << IsOpen(other);
  });
  // no label of another kind, nor one that no library has, opens a library
  CHECK(facts == "1 0 0 0 1 1 1 0");
}

TEST_CASE("deferred libraries: lists of registrations open all libraries with such labels",
          "[core][plugins]") {
  const CPlugins plugins;
  const std::string entity = plugins.AddWithIndex("argos3_test_numbered_2", kNumbered2);
  const std::string other =
      plugins.AddWithIndex("argos3_test_numbered_3", {Controller("test_numbered_controller_3")});
  const std::string facts = InChild([&](std::ostream& out) {
    out << TEntities::GetTypes().count("test-marker-2") << ' ' << IsOpen(other) << ' '
        << TControllers::GetTypeMap().count("test_numbered_controller_3") << ' ' << IsOpen(other);
  });
  CHECK(facts == "1 0 1 1");
  CHECK(InChild([&](std::ostream& out) {
          CDynamicLoading::LoadAllLibraries();
          out << IsOpen(entity) << IsOpen(other);
        }) == "11");
  CHECK(InChild([&](std::ostream& out) {
          CDynamicLoading::LoadLibrariesOfLabels({"no-label", "test-marker-2"});
          out << IsOpen(entity) << IsOpen(other);
        }) == "10");
  // after this no label of the kind is known any more
  CHECK(InChild([&](std::ostream& out) {
          TControllers::Destroy();
          out << TControllers::Exists("test_numbered_controller_3") << IsOpen(other);
        }) == "00");
}

TEST_CASE("deferred libraries: an index does not count for another file in the library's place",
          "[core][plugins]") {
  const CPlugins plugins;
  const std::string library = plugins.AddWithIndex("argos3_test_numbered_2", {});
  CHECK(InChild([&](std::ostream& out) { out << IsOpen(library); }) == "0");
  CHECK(GetIndexPath(library) == plugins.Folder().Path("libargos3_test_numbered_2.labels"));
  fs::copy(kBuilt + "/libargos3_test_numbered_3.so", library, fs::copy_options::overwrite_existing);
  CHECK(InChild([&](std::ostream& out) { out << IsOpen(library); }) == "1");
  CHECK_FALSE(ReadLabelIndex(library).has_value());
  // nor does a damaged one
  const std::string index = GetIndexPath(library);
  WriteLabelIndex(library, {Controller("a b")});
  CHECK(ReadLabelIndex(library) == std::vector{Controller("a b")});
  std::ofstream(index, std::ios::app) << "nothing";
  CHECK_FALSE(ReadLabelIndex(library).has_value());
  std::ofstream(index) << "";
  CHECK_FALSE(ReadLabelIndex(library).has_value());
}

TEST_CASE("deferred libraries: a user's library that has the same class replaces it",
          "[core][plugins]") {
  const CPlugins plugins;
  plugins.AddWithIndex("argos3_test_good", {Controller("test_good_controller")});
  plugins.Add("argos3_test_same_class");
  const std::string facts = InChild([](std::ostream& out) {
    LOGERR.Flush();
    out << TControllers::GetTypeMap().at("test_good_controller")->Library;
  });
  CHECK_THAT(facts, Contains("libargos3_test_good.so\" and by \"") &&
                        Contains("libargos3_test_same_class.so\", with the same class") &&
                        Catch::EndsWith("libargos3_test_same_class.so"));
}

TEST_CASE("deferred libraries: a user's library with another class of the label is an error",
          "[core][plugins]") {
  const CPlugins plugins;
  plugins.AddWithIndex("argos3_test_good", {Controller("test_good_controller")});
  plugins.Add("argos3_test_duplicate");
  CHECK_THAT(InChild([](std::ostream&) {}),
             Contains("libargos3_test_duplicate.so\" cannot be used:") &&
                 Contains("libargos3_test_good.so\" and by \"") &&
                 Contains("with the classes CTestGoodController and CTestDuplicateController"));
}

TEST_CASE("deferred libraries: those that a user's library needs are opened before it",
          "[core][plugins]") {
  const CPlugins plugins;
  // linked with it, or only using its symbols
  const int number = GENERATE(1, 2);
  const std::string suffix = std::to_string(number);
  const std::string needed = plugins.AddWithIndex("argos3_test_needed_" + suffix, {});
  const std::string other = plugins.AddWithIndex("argos3_test_numbered_2", kNumbered2);
  plugins.Add("argos3_test_needing_" + suffix);
  CHECK(InChild([&](std::ostream& out) { out << IsOpen(needed) << IsOpen(other); }) == "10");
}

TEST_CASE("deferred libraries: a library that cannot be opened is an error of the look-up",
          "[core][plugins]") {
  const CPlugins plugins;
  plugins.AddWithIndex("argos3_test_unresolved", {Controller("test_unresolved")});
  CHECK_THAT(InChild([](std::ostream& out) {
               out << "started, ";
               TControllers::Exists("test_unresolved");
             }),
             Contains("started, threw: ") && Contains("libargos3_test_unresolved.so\" cannot be") &&
                 Contains("argosTestVariableThatNobodyDefines"));
}

TEST_CASE("deferred libraries: damaged files have no build id", "[core][plugins]") {
  const CTemporaryFolder folder;
  const std::string whole = kBuilt + "/libargos3_test_needing_1.so";
  const std::string id = ReadBuildId(whole);
  const std::vector<std::string> needed = ListNeeded(whole);
  CHECK(id.size() == 40);
  CHECK(std::count(needed.begin(), needed.end(), "libargos3_test_needed_1.so") == 1);
  std::ifstream file(whole, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const std::string path = folder.Path("library");
  for (const size_t size : {size_t(0), size_t(10), size_t(70), bytes.size() / 2}) {
    folder.Write("library", bytes.substr(0, size));
    CHECK(ListNeeded(path).empty());
  }
  // its header promises more than it has
  std::string damaged = bytes;
  std::fill(damaged.begin() + 32, damaged.begin() + 60, '\xff');
  folder.Write("library", damaged);
  CHECK(ReadBuildId(path).empty());
  CHECK(ReadBuildId(folder.Path("none")).empty());
}

}  // namespace deferred_libraries_test
