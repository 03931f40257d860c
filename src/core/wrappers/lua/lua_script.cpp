#include <argos3/core/wrappers/lua/lua_script.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/input_file.h>
#include <argos3/core/utility/files/nearby_file.h>
#include <argos3/core/utility/text/classic_locale.h>
#include <argos3/core/wrappers/lua/lua_utility.h>

#include <filesystem>
#include <iterator>
#include <map>
#include <mutex>

namespace argos {

namespace {

namespace fs = std::filesystem;

struct SStateCloser {
  void operator()(lua_State* state) const { lua_close(state); }
};

/** Identifies a version of a file. */
struct SVersion {
  fs::file_time_type Written;
  std::uintmax_t Size = 0;

  bool operator==(const SVersion& other) const {
    return Written == other.Written && Size == other.Size;
  }
};

struct SCached {
  SVersion Version;
  std::weak_ptr<const SLuaScript> Script;  // owned by its users, not by this cache
};

// shared by all simulators of the process
std::mutex g_cacheMutex;
std::map<std::string, SCached>& GetCache() {
  static std::map<std::string, SCached> cache;
  return cache;
}

std::string Absolute(const fs::path& path) {
  std::error_code ignored;
  return fs::absolute(path, ignored).lexically_normal().string();
}

std::string Read(const std::string& path) {
  std::string text;
  std::string problem;
  if (!ReadInputFile(path, text, problem)) {
    THROW_ARGOSEXCEPTION("cannot read the Lua script \"" << path << "\": " << problem);
  }
  // like the program lua: skip the byte order mark, and a first line for the shell
  if (text.rfind("\xEF\xBB\xBF", 0) == 0) {
    text.erase(0, 3);
  }
  if (text.rfind('#', 0) == 0) {
    text.erase(0, std::min(text.find('\n'), text.size()));
  }
  return text;
}

int AppendBytes(lua_State*, const void* bytes, std::size_t size, void* bytecode) {
  static_cast<std::string*>(bytecode)->append(static_cast<const char*>(bytes), size);
  return 0;
}

std::string Compile(const std::string& text, const std::string& path, bool allowBytecode) {
  if (!allowBytecode && text.rfind(LUA_SIGNATURE, 0) == 0) {
    THROW_ARGOSEXCEPTION("the Lua script \""
                         << path << "\" is precompiled, and wrong bytecode crashes the program; "
                         << "use the source, or set unsafe=\"true\" in <params>");
  }
  const CClassicLocale locale;
  const std::unique_ptr<lua_State, SStateCloser> state(luaL_newstate());
  if (state == nullptr) {
    THROW_ARGOSEXCEPTION("not enough memory to compile the Lua script \"" << path << '"');
  }
  const std::string name = '@' + path;
  if (luaL_loadbufferx(state.get(), text.data(), text.size(), name.c_str(), nullptr) != LUA_OK) {
    THROW_ARGOSEXCEPTION("the Lua script \"" << path << "\" cannot be compiled\n"
                                             << lua_tostring(state.get(), -1));
  }
  std::string bytecode;
  constexpr int kKeepLineNumbers = 0;
  lua_dump(state.get(), AppendBytes, &bytecode, kKeepLineNumbers);
  return bytecode;
}

}  // namespace

std::shared_ptr<const SLuaScript> SLuaScript::Load(const std::string& name,
                                                   const std::string& experimentFile,
                                                   bool allowBytecode) {
  const std::string path = FindNearbyFile(name, experimentFile, "Lua script");
  // the path as the user wrote it is part of the bytecode, for messages
  const std::string key = path + '\n' + Absolute(path) + (allowBytecode ? "\nb" : "");
  std::error_code ignored;
  const SVersion version{fs::last_write_time(path, ignored), fs::file_size(path, ignored)};

  const std::lock_guard<std::mutex> lock(g_cacheMutex);
  std::map<std::string, SCached>& cache = GetCache();
  if (const auto found = cache.find(key);
      found != cache.end() && found->second.Version == version) {
    if (std::shared_ptr<const SLuaScript> script = found->second.Script.lock()) {
      return script;
    }
  }
  std::string folder = fs::path(path).parent_path().string();
  folder = folder.empty() ? "." : folder;
  const std::string text = Read(path);
  auto script = std::make_shared<const SLuaScript>(
      SLuaScript{path, folder, Compile(text, path, allowBytecode), SLuaSource::Read(text, folder)});
  for (auto entry = cache.begin(); entry != cache.end();) {
    entry = entry->second.Script.expired() ? cache.erase(entry) : std::next(entry);
  }
  cache[key] = {version, script};
  return script;
}

std::shared_ptr<const SLuaScript> SLuaScript::MakeVariant(const std::string& text) const {
  constexpr bool kAllowBytecode = false;
  return std::make_shared<const SLuaScript>(SLuaScript{
      Path, Folder, Compile(text, Path, kAllowBytecode), SLuaSource::Read(text, Folder)});
}

std::string SLuaScript::ReadText() const {
  return Read(Path);
}

}  // namespace argos
