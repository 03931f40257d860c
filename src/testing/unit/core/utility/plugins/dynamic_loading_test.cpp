// Uses the libraries of src/testing/support/plugins in <build>/testing/plugins. Each test case
// loads the libraries that it needs, so that it can run in a process of its own or after others.

#include <argos3/core/utility/logging/log_control.h>
#include <argos3/core/utility/plugins/dynamic_loading.h>

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/plugins/registration.h>
#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

namespace dynamic_loading_test {

using namespace argos;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

const std::string kFolder = InBuildTree("testing/plugins");
const std::string kGood = kFolder + "/libargos3_test_good.so";

void SetPluginPath(const std::string& path) {
  setenv("ARGOS_PLUGIN_PATH", path.c_str(), 1);
}

// an empty folder of this process, removed by the destructor
class CTemporaryFolder {
 public:
  explicit CTemporaryFolder(const std::string& name)
      : m_path(fs::temp_directory_path() / (name + "." + std::to_string(getpid()))) {
    fs::remove_all(m_path);
    fs::create_directories(m_path);
  }
  ~CTemporaryFolder() { fs::remove_all(m_path); }
  std::string Path() const { return m_path.string(); }

 private:
  fs::path m_path;
};

// the output of the standard logs during its lifetime
class CCapturedLogs {
 public:
  CCapturedLogs() {
    LOG.Flush();
    LOGERR.Flush();
    LOG.DisableColoredOutput();
    LOGERR.DisableColoredOutput();
    m_out = LOG.GetStream().rdbuf(m_text.rdbuf());
    m_err = LOGERR.GetStream().rdbuf(m_text.rdbuf());
  }
  ~CCapturedLogs() {
    LOG.Flush();
    LOGERR.Flush();
    LOG.GetStream().rdbuf(m_out);
    LOGERR.GetStream().rdbuf(m_err);
  }
  std::string Text() {
    LOG.Flush();
    LOGERR.Flush();
    return m_text.str();
  }

 private:
  std::ostringstream m_text;
  std::streambuf* m_out;
  std::streambuf* m_err;
};

}  // namespace

TEST_CASE("dynamic loading: a library registers its plug-ins", "[core][plugins]") {
  CCapturedLogs logs;
  const CDynamicLoading::TDLHandle handle = CDynamicLoading::LoadLibrary(kGood);
  CHECK(handle != nullptr);
  REQUIRE(CFactory<CCI_Controller>::Exists("test_good_controller"));
  const std::unique_ptr<CCI_Controller> controller(
      CFactory<CCI_Controller>::New("test_good_controller"));
  controller->SetId("r");
  controller->ControlStep();
  CHECK(controller->GetId() == "r+");
  const auto& info = *CFactory<CCI_Controller>::GetTypeMap().at("test_good_controller");
  CHECK(info.Library.find("libargos3_test_") != std::string::npos);
  CHECK(info.Author == "undefined");
  // a library is loaded once, also under another path
  CHECK(CDynamicLoading::LoadLibrary(kFolder + "/../plugins/libargos3_test_good") == handle);
  SetPluginPath(kFolder);
  CHECK(CDynamicLoading::LoadLibrary("libargos3_test_good") == handle);
}

TEST_CASE("dynamic loading: libraries are searched for in the plug-in path, with the suffix added",
          "[core][plugins]") {
  CCapturedLogs logs;
  SetPluginPath("/no/such/folder:" + fs::path(kFolder).parent_path().string());
  CHECK_NOTHROW(CDynamicLoading::LoadLibrary("plugins/libargos3_test_good"));
  CHECK_NOTHROW(CDynamicLoading::UnloadLibrary("plugins/libargos3_test_good"));
  CHECK_THROWS_WITH(
      CDynamicLoading::UnloadLibrary("plugins/libargos3_test_good"),
      Contains("\"plugins/libargos3_test_good\" cannot be unloaded, because it was not loaded"));
  CHECK_NOTHROW(CDynamicLoading::LoadLibrary("plugins/libargos3_test_good"));
  CDynamicLoading::UnloadAllLibraries();
  CHECK_THROWS_AS(CDynamicLoading::UnloadLibrary(kGood), CARGoSException);
}

TEST_CASE("dynamic loading: the error on a missing library lists every attempt",
          "[core][plugins]") {
  SetPluginPath("/a:/b");
  CHECK_THROWS_WITH(
      CDynamicLoading::LoadLibrary("libnone"),
      Contains("The library \"libnone\" cannot be loaded; tried:\n[FATAL]   /a/libnone[.so]: no "
               "such file\n[FATAL]   /b/libnone[.so]: no such file\n") &&
          Contains("\n[FATAL]   ./libnone[.so]: no such file"));
  // an absolute path is not searched for elsewhere
  CHECK_THROWS_WITH(CDynamicLoading::LoadLibrary("/x/libnone"),
                    "[FATAL] The library \"/x/libnone\" cannot be loaded; tried:\n[FATAL]   "
                    "/x/libnone[.so]: no such file");
  CHECK_THROWS_WITH(CDynamicLoading::LoadLibrary(kFolder + "/libargos3_test_goood.so"),
                    Contains("cannot be loaded; did you mean \"libargos3_test_good\"") &&
                        Contains("/libargos3_test_goood.so: no such file"));
  CHECK_THROWS_WITH(CDynamicLoading::LoadLibrary(kFolder),
                    Contains(kFolder + ": it is a directory"));
}

TEST_CASE("dynamic loading: libraries are searched beside the experiment, after the plug-in path",
          "[core][plugins]") {
  const CTemporaryFolder plugins("argos_dynamic_loading_path");
  const CTemporaryFolder project("argos_dynamic_loading_project");
  const std::string experiments = project.Path() + "/experiments";
  fs::create_directories(experiments + "/build");
  fs::create_directories(project.Path() + "/build");
  SetPluginPath(plugins.Path());
  // none of these loads, so that the error lists all of them in the order of the search
  const std::vector<std::string> files = {
      plugins.Path() + "/libplaced.so", experiments + "/libplaced.so",
      experiments + "/build/libplaced.so", experiments + "/../build/libplaced.so"};
  for (const std::string& file : files) {
    std::ofstream(file) << "this is no library";
  }
  const auto errorOf = [&](const std::string& name) {
    try {
      CDynamicLoading::LoadLibrary(name, experiments + "/e.argos");
    } catch (const CARGoSException& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string error = errorOf("libplaced");
  CAPTURE(error);
  size_t place = 0;
  for (const std::string& file : files) {
    const size_t found = error.find("\n[FATAL]   " + file + ": ");
    CAPTURE(file);
    CHECK(found != std::string::npos);
    CHECK(found > place);
    place = found;
  }
  // only a name with a slash is searched in the folder above, the root of a project
  CHECK_THAT(error, !Contains("/../libplaced"));
  CHECK_THAT(errorOf("build/libplaced"),
             Contains("\n[FATAL]   " + experiments + "/../build/libplaced.so: "));
}

TEST_CASE("dynamic loading: the error on a library that does not load gives the reason",
          "[core][plugins]") {
  CHECK_THROWS_WITH(CDynamicLoading::LoadLibrary(kFolder + "/libargos3_test_unresolved"),
                    Contains("argosTestVariableThatNobodyDefines"));
  const CTemporaryFolder folder("argos_dynamic_loading_text");
  std::ofstream(folder.Path() + "/libtext.so") << "this is no library";
  CHECK_THROWS_WITH(CDynamicLoading::LoadLibrary(folder.Path() + "/libtext.so"),
                    Contains("libtext.so: ") && Contains("cannot be loaded; tried:"));
}

TEST_CASE("dynamic loading: a library of another build is refused", "[core][plugins]") {
  CHECK_THROWS_WITH(CDynamicLoading::LoadLibrary(kFolder + "/libargos3_test_wrong_build"),
                    Contains("libargos3_test_wrong_build.so\" cannot be used:") &&
                        Contains("was built against another version or with other options: it has "
                                 "real=float, core=000000000000, the core has real=double, core="));
  CHECK_FALSE(CFactory<CCI_Controller>::Exists("test_wrong_build_controller"));
}

TEST_CASE("dynamic loading: the error on a label in two libraries names both", "[core][plugins]") {
  CCapturedLogs logs;
  CDynamicLoading::LoadLibrary(kGood);
  CHECK_THROWS_WITH(CDynamicLoading::LoadLibrary(kFolder + "/libargos3_test_duplicate"),
                    Contains("label \"test_good_controller\" of CCI_Controller is registered by") &&
                        Contains("and by ") &&
                        Contains("libargos3_test_duplicate.so\", with the classes "
                                 "CTestGoodController and CTestDuplicateController;"));
  CHECK_THAT(logs.Text(), !Contains("WARNING"));
  // the first registration stays
  CHECK(CFactory<CCI_Controller>::GetTypeMap()
            .at("test_good_controller")
            ->Library.find("duplicate") == std::string::npos);
}

TEST_CASE("dynamic loading: of two libraries with one class the last one counts, with a warning",
          "[core][plugins]") {
  CCapturedLogs logs;
  CDynamicLoading::LoadLibrary(kGood);
  CHECK_NOTHROW(CDynamicLoading::LoadLibrary(kFolder + "/libargos3_test_same_class"));
  const std::string text = logs.Text();
  CHECK_THAT(text, Contains("[WARNING] The label \"test_good_controller\" of CCI_Controller is "
                            "registered by \"") &&
                       Contains("libargos3_test_good.so\" and by \"") &&
                       Contains("libargos3_test_same_class.so\", with the same class "
                                "CTestGoodController: the last one counts"));
  CHECK(text.find("WARNING") == text.rfind("WARNING"));
  CHECK_THAT(CFactory<CCI_Controller>::GetTypeMap().at("test_good_controller")->Library,
             Catch::EndsWith("libargos3_test_same_class.so"));
}

TEST_CASE("dynamic loading: a class that has the functions of another library's is reported",
          "[core][plugins]") {
  CCapturedLogs logs;
  CDynamicLoading::LoadLibrary(kGood);
  CHECK_NOTHROW(CDynamicLoading::LoadLibrary(kFolder + "/libargos3_test_twin"));
  CHECK_THAT(
      logs.Text(),
      Contains("[WARNING] The class CTestGoodController of label \"test_twin_controller\"") &&
          Contains("has the name of a class in \"") &&
          Contains("libargos3_test_good.so\", whose functions the dynamic linker gives it"));
  // two versions of one class, or two classes: their objects differ
  CHECK_THROWS_WITH(CDynamicLoading::LoadLibrary(kFolder + "/libargos3_test_big_twin"),
                    Contains("libargos3_test_big_twin.so\" cannot be used:") &&
                        Contains("the class CTestGoodController of label \"test_big_twin_"));
}

TEST_CASE("dynamic loading: libraries that another one is linked with are found beside it",
          "[core][plugins]") {
  const CTemporaryFolder folder("argos_dynamic_loading_needed");
  const std::string needing = folder.Path() + "/libneeding.so";
  fs::copy(kFolder + "/libargos3_test_needing_1.so", needing);
  SetPluginPath("");
  CHECK_THROWS_WITH(
      CDynamicLoading::LoadLibrary(needing),
      Contains("libneeding.so: libargos3_test_needed_1.so: cannot open shared object file") &&
          Contains("linked with \"libargos3_test_needed_1.so\"") &&
          Contains("ARGOS_PLUGIN_PATH or LD_LIBRARY_PATH, or link with -Wl,-rpath,FOLDER"));
  fs::copy(kFolder + "/libargos3_test_needed_1.so", folder.Path() + "/libargos3_test_needed_1.so");
  CHECK_NOTHROW(CDynamicLoading::LoadLibrary(needing));
}

TEST_CASE("dynamic loading: libraries that fail are loaded after those that have their symbols",
          "[core][plugins]") {
  const CTemporaryFolder folder("argos_dynamic_loading_order");
  fs::copy(kFolder + "/libargos3_test_needing_2.so", folder.Path() + "/liba.so");
  SetPluginPath(folder.Path());
  CCapturedLogs logs;
  CHECK_THROWS_WITH(CDynamicLoading::LoadAllLibraries(),
                    Contains("liba.so\" cannot be loaded") &&
                        Contains("undefined symbol: argosTestNeeded2") &&
                        Contains("Link it with the library that has this symbol"));
  fs::copy(kFolder + "/libargos3_test_needed_2.so", folder.Path() + "/libb.so");
  CHECK_NOTHROW(CDynamicLoading::LoadAllLibraries());
}

TEST_CASE("dynamic loading: all libraries of the plug-in path are loaded, each name once",
          "[core][plugins]") {
  const std::string library = kFolder + "/libargos3_test_one_of_all.so";
  const CTemporaryFolder first("argos_dynamic_loading_a");
  const CTemporaryFolder second("argos_dynamic_loading_b");
  fs::copy(library, first.Path() + "/libargos3_test_one_of_all.so");
  fs::copy(library, second.Path() + "/libargos3_test_one_of_all.so");
  std::ofstream(first.Path() + "/notes.txt") << "not a library";
  SetPluginPath("/no/such/folder:" + first.Path() + ":" + second.Path());
  CCapturedLogs logs;
  CLogControl::SetLevel(ELogLevel::Debug);
  CHECK_NOTHROW(CDynamicLoading::LoadAllLibraries());
  const std::string text = logs.Text();
  CLogControl::SetLevel(ELogLevel::Info);
  CHECK_THAT(text, Contains("[WARNING] The plug-in directory \"/no/such/folder\" cannot be read"));
  CHECK_THAT(text, Contains("[DEBUG] Loaded library \"" + first.Path()));
  CHECK_THAT(text, !Contains("Loaded library \"" + second.Path()));
  // the core library is not a plug-in
  CHECK_THAT(text, !Contains("libargos3core"));
  CHECK(CFactory<CCI_Controller>::Exists("test_one_of_all_controller"));
}

TEST_CASE("dynamic loading: a library in the plug-in path that does not load is fatal",
          "[core][plugins]") {
  const CTemporaryFolder folder("argos_dynamic_loading_bad");
  std::ofstream(folder.Path() + "/libbroken.so") << "this is no library";
  SetPluginPath(folder.Path());
  CCapturedLogs logs;
  CHECK_THROWS_WITH(CDynamicLoading::LoadAllLibraries(), Contains("libbroken.so"));
}

TEST_CASE("dynamic loading: the search path can be queried", "[core][plugins]") {
  SetPluginPath("/a::/b");
  const std::vector<std::string> paths = GetPluginSearchPaths();
  REQUIRE(paths.size() >= 4);
  CHECK(paths[0] == "/a");
  CHECK(paths[1] == "/b");
  // a file in the working directory must not replace an installed library
  CHECK(paths.back() == ".");
  // the folder of the core library
  CHECK(paths[2] ==
        fs::canonical(GetLibraryOf(reinterpret_cast<const void*>(&GetCoreBuildId))).parent_path());
}

}  // namespace dynamic_loading_test
