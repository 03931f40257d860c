#include "lua_tester.h"

#include <argos3/core/wrappers/lua/lua_script.h>
#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

namespace lua_script_test {

using namespace argos;
using Catch::Contains;

namespace {

namespace fs = std::filesystem;

// tests of this file run concurrently, each in a process of its own
const std::string kFolder = "lua_script_test_" + std::to_string(getpid());
const std::string kSubfolder = "scripts_" + std::to_string(getpid());

/** A folder of scripts with a subfolder of an experiment; removed by the destructor. */
class CFolder {
 public:
  CFolder() { fs::create_directories(m_path / "experiment" / kSubfolder); }
  ~CFolder() {
    std::error_code ignored;
    fs::remove_all(m_path, ignored);
  }
  CFolder(const CFolder&) = delete;
  CFolder& operator=(const CFolder&) = delete;

  std::string Write(const std::string& name, const std::string& text) const {
    std::ofstream(m_path / name, std::ios::binary) << text;
    return (m_path / name).string();
  }
  std::string Experiment() const { return (m_path / "experiment" / "e.argos").string(); }
  void SetTime(const std::string& name, int seconds) const {
    fs::last_write_time(m_path / name, fs::file_time_type(std::chrono::seconds(seconds)));
  }

 private:
  const fs::path m_path = InBuildTree(kFolder);
};

}  // namespace

TEST_CASE("lua script: is searched for in the working directory, then beside the experiment",
          "[lua][script]") {
  const CFolder folder;
  const std::string path =
      folder.Write("experiment/" + kSubfolder + "/a.lua", "where = 'experiment'");
  CHECK(SLuaScript::Load(kSubfolder + "/a.lua", folder.Experiment())->Path == path);
  CHECK(SLuaScript::Load(path, "")->Path == path);
  CHECK(SLuaScript::Load(path, folder.Experiment())->Folder == fs::path(path).parent_path());
  // the test runs in the build folder
  const fs::path here = fs::current_path() / kSubfolder;
  REQUIRE(fs::create_directory(here));
  std::ofstream(here / "a.lua") << "where = 'here'";
  CHECK(SLuaScript::Load(kSubfolder + "/a.lua", folder.Experiment())->Path ==
        kSubfolder + "/a.lua");
  CHECK(SLuaScript::Load(kSubfolder + "/a.lua", "")->Folder == kSubfolder);
  fs::remove(here / "a.lua");
  fs::remove(here);
}

TEST_CASE("lua script: the error on a missing script lists the places searched", "[lua][script]") {
  const CFolder folder;
  CHECK_THROWS_WITH(SLuaScript::Load("none.lua", folder.Experiment()),
                    Contains("there is no Lua script \"none.lua\"") &&
                        Contains((fs::current_path() / "none.lua").string()) &&
                        Contains(kFolder + "/experiment/none.lua"));
  CHECK_THROWS_WITH(SLuaScript::Load("none.lua", ""), Contains("none.lua"));
  CHECK_THROWS_WITH(SLuaScript::Load("/none.lua", folder.Experiment()),
                    Contains("looked for \"/none.lua\"") && !Contains("experiment"));
  // a folder is not a script
  CHECK_THROWS_WITH(SLuaScript::Load(kSubfolder, folder.Experiment()), Contains("no Lua script"));
}

TEST_CASE("lua script: a syntax error has Lua's message with file and line", "[lua][script]") {
  const CFolder folder;
  const std::string path = folder.Write("wrong.lua", "x = 1\ny = = 2\n");
  CHECK_THROWS_WITH(
      SLuaScript::Load(path, ""),
      Contains("cannot be compiled") && Contains("wrong.lua:2: unexpected symbol near '='"));
}

TEST_CASE("lua script: runs, and messages give its lines", "[lua][script]") {
  const CFolder folder;
  const std::string path =
      folder.Write("e.lua", "answer = 42\n\nfunction f() error('no good') end\n");
  CLuaTester lua;
  lua.Execute(*SLuaScript::Load(path, ""));
  CHECK(lua.Get("answer") == "42");
  CHECK_THAT(lua.GetError("f()"), Contains("e.lua:3: no good"));
}

TEST_CASE("lua script: a UTF-8 byte order mark and a shell line are skipped", "[lua][script]") {
  const CFolder folder;
  const std::string path = folder.Write(
      "shell.lua", "\xEF\xBB\xBF#!/usr/bin/lua\nanswer = debug.getinfo(1).currentline");
  CLuaTester lua;
  lua.Execute(*SLuaScript::Load(path, ""));
  CHECK(lua.Get("answer") == "2");
  CHECK_NOTHROW(SLuaScript::Load(folder.Write("only.lua", "#!/usr/bin/lua"), ""));
  CHECK_NOTHROW(SLuaScript::Load(folder.Write("empty.lua", ""), ""));
}

TEST_CASE("lua script: require finds modules beside the script", "[lua][script]") {
  const CFolder folder;
  folder.Write("experiment/helper.lua", "return { name = 'helper' }");
  fs::create_directories(InBuildTree(kFolder + "/experiment/package"));
  folder.Write("experiment/package/init.lua", "return { name = 'package' }");
  const std::string path = folder.Write(
      "experiment/main.lua", "names = require('helper').name .. require('package').name");
  CLuaTester lua;
  lua.Do("package.loaded.package = nil");
  lua.Execute(*SLuaScript::Load(path, ""));
  CHECK(lua.Get("names") == "helperpackage");
}

TEST_CASE("lua script: is compiled once while it is in use and its file unchanged",
          "[lua][script]") {
  const CFolder folder;
  const std::string path = folder.Write("c.lua", "x = 1");
  const auto first = SLuaScript::Load(path, "");
  CHECK(SLuaScript::Load(path, "") == first);
  CHECK(SLuaScript::Load(fs::path(path).filename().string(), path) == first);
  // a change is detected by the size of the file or by its time
  folder.Write("c.lua", "x = 22");
  const auto second = SLuaScript::Load(path, "");
  CHECK(second != first);
  folder.Write("c.lua", "x = 33");
  folder.SetTime("c.lua", 12345);
  const auto third = SLuaScript::Load(path, "");
  CHECK(third != second);
  CLuaTester lua;
  lua.Execute(*third);
  CHECK(lua.Get("x") == "33");
  lua.Execute(*first);
  CHECK(lua.Get("x") == "1");
}

TEST_CASE("lua script: threads may load one concurrently", "[lua][script][threads]") {
  const CFolder folder;
  const std::string path = folder.Write("t.lua", "x = 1");
  std::vector<std::shared_ptr<const SLuaScript>> scripts(8);
  std::vector<std::thread> threads;
  for (auto& script : scripts) {
    threads.emplace_back([&script, &path] { script = SLuaScript::Load(path, ""); });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  for (const auto& script : scripts) {
    REQUIRE(script != nullptr);
    CHECK(script->Bytecode == scripts.front()->Bytecode);
  }
}

}  // namespace lua_script_test
