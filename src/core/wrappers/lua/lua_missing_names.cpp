#include <argos3/core/wrappers/lua/lua_missing_names.h>

#include <argos3/core/utility/files/input_file.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/core/wrappers/lua/lua_parameters.h>
#include <argos3/core/wrappers/lua/lua_utility.h>

#include <algorithm>
#include <cctype>
#include <new>
#include <string_view>
#include <vector>

namespace argos {

namespace {

constexpr const char* kRobot = "robot";
// limit of the names of a table in a message
constexpr std::size_t kMaxNames = 20;

/** Names joined by dots, and perhaps a last colon: robot.wheels.set_velocity */
struct SChain {
  std::vector<std::string> Names;
  bool IsAssigned = false;
};

/** What a chain lacks. */
struct SMissing {
  std::size_t Place = 0;  // place of the first name without a value
  bool IsMissing = false;
  std::vector<std::string> Known;  // names in the table that should have it
};

bool IsNameStart(char c) {
  return c == '_' || std::isalpha(static_cast<unsigned char>(c)) != 0;
}

bool IsNamePart(char c) {
  return IsNameStart(c) || std::isdigit(static_cast<unsigned char>(c)) != 0;
}

std::size_t SkipBlanks(std::string_view line, std::size_t at) {
  while (at < line.size() && (line[at] == ' ' || line[at] == '\t')) {
    ++at;
  }
  return at;
}

std::string ReadName(std::string_view line, std::size_t& at) {
  const std::size_t start = at;
  while (at < line.size() && IsNamePart(line[at])) {
    ++at;
  }
  return std::string(line.substr(start, at - start));
}

SChain ReadChain(std::string_view line, std::size_t& at) {
  SChain chain;
  chain.Names.push_back(ReadName(line, at));
  while (at + 1 < line.size() && (line[at] == '.' || line[at] == ':') &&
         IsNameStart(line[at + 1])) {
    ++at;
    chain.Names.push_back(ReadName(line, at));
  }
  const std::size_t next = SkipBlanks(line, at);
  chain.IsAssigned =
      next < line.size() && line[next] == '=' && (next + 1 == line.size() || line[next + 1] != '=');
  return chain;
}

/** @return where the string ends that begins at a quotation mark. */
std::size_t SkipString(std::string_view line, std::size_t at) {
  const char mark = line[at];
  for (++at; at < line.size() && line[at] != mark; ++at) {
    at += line[at] == '\\' ? 1 : 0;
  }
  return at + 1;
}

std::vector<SChain> FindChains(std::string_view line) {
  std::vector<SChain> chains;
  for (std::size_t at = 0; at < line.size();) {
    if (line.substr(at, 2) == "--") {
      break;
    }
    if (line[at] == '"' || line[at] == '\'') {
      at = SkipString(line, at);
    } else if (IsNameStart(line[at]) && (at == 0 || line[at - 1] != '.')) {
      chains.push_back(ReadChain(line, at));
    } else {
      // a number such as 1e5, or the rest of a name after ')', is no chain
      at += IsNamePart(line[at]) ? ReadName(line, at).size() : 1;
    }
  }
  return chains;
}

// tables of the state

struct SLookUp {
  const SChain* Chain;
  SMissing* Missing;
};

// a C function: what it calls may raise errors for lack of memory, so it has no objects of its own
int LookUp(lua_State* state) {
  const auto& lookUp = *static_cast<const SLookUp*>(lua_touserdata(state, 1));
  const std::vector<std::string>& names = lookUp.Chain->Names;
  lua_pushglobaltable(state);
  for (std::size_t i = 0; i < names.size() && lua_istable(state, -1); ++i) {
    luaL_checkstack(state, 4, nullptr);
    CLuaParameters::Open(state, -1);
    lua_pushlstring(state, names[i].data(), names[i].size());
    if (lua_rawget(state, -2) != LUA_TNIL) {
      continue;
    }
    lua_pop(state, 1);
    lookUp.Missing->Place = i;
    lookUp.Missing->IsMissing = true;
    try {
      for (lua_pushnil(state); lua_next(state, -2) != 0; lua_pop(state, 1)) {
        if (lua_type(state, -2) == LUA_TSTRING) {
          lookUp.Missing->Known.emplace_back(lua_tostring(state, -2));
        }
      }
    } catch (const std::bad_alloc&) {
      // must not pass through Lua: the names so far are enough
      return 0;
    }
    break;
  }
  return 0;
}

SMissing FindMissing(lua_State* state, const SChain& chain) {
  SMissing missing;
  SLookUp lookUp{&chain, &missing};
  const int top = lua_gettop(state);
  lua_pushcfunction(state, LookUp);
  lua_pushlightuserdata(state, &lookUp);
  if (lua_pcall(state, 1, 0, 0) != LUA_OK) {
    missing.IsMissing = false;
  }
  lua_settop(state, top);
  std::sort(missing.Known.begin(), missing.Known.end());
  return missing;
}

// explanation

/** The name in "(field 'wheels')"; empty if the message has none of the kind. */
std::string FindName(const std::string& message, const std::string& kind) {
  const std::string before = "(" + kind + " '";
  const std::size_t start = message.find(before);
  if (start == std::string::npos) {
    return "";
  }
  const std::size_t name = start + before.size();
  return message.substr(name, message.find('\'', name) - name);
}

std::string JoinNames(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMaxNames); ++i) {
    text += (i == 0 ? "" : ", ") + names[i];
  }
  return text + (names.size() > kMaxNames ? ", ..." : "");
}

std::string Explain(const SChain& chain, const SMissing& missing) {
  const std::string& name = chain.Names[missing.Place];
  const std::string near = NearestNames(name, missing.Known);
  if (missing.Place == 0) {
    return near.empty() ? ""
                        : "there is no global \"" + name + '"' + DidYouMean(name, missing.Known);
  }
  std::string owner = chain.Names[0];
  for (std::size_t i = 1; i < missing.Place; ++i) {
    owner += '.' + chain.Names[i];
  }
  const std::string text = owner + " has no \"" + name + '"';
  if (!near.empty()) {
    return text + DidYouMean(name, missing.Known);
  }
  return text + "; it has: " + JoinNames(missing.Known) +
         (owner == kRobot ? "; is its device in <sensors> or <actuators>?" : "");
}

class CExplainer {
 public:
  CExplainer(lua_State* state, const std::string& message)
      : m_state(state), m_global(FindName(message, "global")) {
    for (const char* const kind : {"field", "method"}) {
      m_field += FindName(message, kind);
    }
    for (const char* const kind : {"local", "upvalue"}) {
      m_variable += FindName(message, kind);
    }
  }

  bool IsNamed() const { return !m_global.empty() || !m_field.empty(); }
  /** Whether a line gives the variable that the message names a value. */
  bool Assigns(std::string_view line) const {
    const std::vector<SChain> chains = FindChains(line);
    return std::any_of(chains.begin(), chains.end(), [this](const SChain& chain) {
      return chain.IsAssigned && chain.Names == std::vector<std::string>{m_variable};
    });
  }

  /** @param isCertain  false: of other lines than that which failed. */
  std::string ExplainLine(std::string_view line, bool isCertain) const {
    for (const SChain& chain : FindChains(line)) {
      const SMissing missing = FindMissing(m_state, chain);
      if (missing.IsMissing && IsCulprit(chain, missing, isCertain)) {
        return Explain(chain, missing);
      }
    }
    return "";
  }

 private:
  bool IsCulprit(const SChain& chain, const SMissing& missing, bool isCertain) const {
    const bool isLast = missing.Place + 1 == chain.Names.size();
    if (isLast && chain.IsAssigned) {
      return false;
    }
    const std::string& name = chain.Names[missing.Place];
    if (IsNamed()) {
      return name == (missing.Place == 0 ? m_global : m_field);
    }
    // a name without a value may be a local variable
    return missing.Place > 0 &&
           (isCertain || (chain.Names[0] == kRobot && !NearestNames(name, missing.Known).empty()));
  }

  lua_State* m_state;
  std::string m_global;
  std::string m_field;
  std::string m_variable;  // local, or upvalue
};

// "attempt to index a number value (local 'reading')", in a loop over a list of numbers
std::string ExplainNumber(const std::string& message, const std::vector<std::string_view>& lines,
                          std::size_t failed) {
  const std::string variable = FindName(message, "local");
  if (variable.empty() || message.find("index a number value") == std::string::npos) {
    return "";
  }
  for (std::size_t i = std::min(lines.size(), failed); i > 0; --i) {
    const std::vector<SChain> chains = FindChains(lines[i - 1]);
    const auto isVariable = [&variable](const SChain& chain) {
      return chain.Names == std::vector<std::string>{variable};
    };
    const auto list = std::find_if(chains.begin(), chains.end(), [](const SChain& chain) {
      return chain.Names[0] == kRobot && chain.Names.size() > 1;
    });
    if (list != chains.end() && std::any_of(chains.begin(), list, isVariable) &&
        lines[i - 1].find("ipairs") != std::string_view::npos) {
      std::string name = kRobot;
      for (std::size_t part = 1; part < list->Names.size(); ++part) {
        name += '.' + list->Names[part];
      }
      return "; line " + std::to_string(i) + ": " + name + " is a list of numbers, without fields";
    }
  }
  return "";
}

bool IsAboutNil(const std::string& message) {
  return message.find("nil value") != std::string::npos ||
         message.find("got nil") != std::string::npos ||
         message.find("got no value") != std::string::npos ||
         message.find("with nil") != std::string::npos;
}

}  // namespace

std::string ExplainMissingName(lua_State* state, const std::string& message,
                               const std::string& file, int line) {
  std::string text;
  std::string problem;
  const bool isAboutNil = IsAboutNil(message);
  if ((!isAboutNil && message.find("index a number value") == std::string::npos) || file.empty() ||
      !ReadInputFile(file, text, problem)) {
    return "";
  }
  std::vector<std::string_view> lines;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    lines.push_back(std::string_view(text).substr(start, end - start));
    start = end + 1;
  }
  if (!isAboutNil) {
    return ExplainNumber(message, lines, static_cast<std::size_t>(line));
  }
  const CExplainer explainer(state, message);
  for (std::size_t i = lines.size(); i > 0; --i) {
    if (explainer.Assigns(lines[i - 1])) {
      const std::string explanation = explainer.ExplainLine(lines[i - 1], true);
      if (!explanation.empty()) {
        return "; line " + std::to_string(i) + ": " + explanation;
      }
    }
  }
  for (std::size_t i = std::min(lines.size(), static_cast<std::size_t>(line)); i > 0; --i) {
    const bool isFailed = i == static_cast<std::size_t>(line);
    const std::string explanation = explainer.ExplainLine(lines[i - 1], isFailed);
    if (!explanation.empty()) {
      return "; " + (isFailed ? "" : "line " + std::to_string(i) + ": ") + explanation;
    }
    if (explainer.IsNamed()) {
      break;
    }
  }
  return "";
}

}  // namespace argos
