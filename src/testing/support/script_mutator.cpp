#include <argos3/testing/support/script_mutator.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace argos {

namespace {

// what replaces a token
constexpr std::array kHostile = {"nil",
                                 "true",
                                 "{}",
                                 "-1",
                                 "0",
                                 "1e308",
                                 "-1e308",
                                 "(0/0)",
                                 "math.huge",
                                 "(1 << 62)",
                                 "\"x\"",
                                 "''",
                                 "robot",
                                 "_G",
                                 "function()",
                                 "end",
                                 "return",
                                 "goto done",
                                 "local",
                                 "while true do",
                                 "for i = 1, 1e9 do",
                                 "until nil",
                                 "(",
                                 ")",
                                 "..",
                                 "#",
                                 "//",
                                 "%",
                                 "~",
                                 "[[",
                                 "\"",
                                 "--[[",
                                 "...",
                                 "error({})",
                                 "error()",
                                 "robot.id",
                                 "coroutine.wrap(step)()",
                                 "setmetatable(_G, {__index = error})",
                                 "setmetatable(robot, {__newindex = error})",
                                 "robot = nil",
                                 "string.rep('x', 1e9)",
                                 "table.concat(robot)",
                                 "vector2()",
                                 "quaternion()",
                                 "load(string.dump(step))()",
                                 "collectgarbage('stop')",
                                 "pcall(step)"};

bool IsWord(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/** The end of the token that starts at a position. */
std::size_t EndOfToken(const std::string& script, std::size_t start) {
  const auto endOfRun = [&](auto belongs) {
    std::size_t end = start;
    while (end < script.size() && belongs(script[end])) {
      ++end;
    }
    return end;
  };
  const char first = script[start];
  if (IsWord(first)) {
    return endOfRun(IsWord);
  }
  if (std::isspace(static_cast<unsigned char>(first)) != 0) {
    return endOfRun([](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; });
  }
  if (script.compare(start, 2, "--") == 0) {
    return endOfRun([](char c) { return c != '\n'; });
  }
  if (first == '"' || first == '\'') {
    const std::size_t end = script.find(first, start + 1);
    return end == std::string::npos ? script.size() : end + 1;
  }
  return start + 1;
}

}  // namespace

std::vector<std::string> ToTokens(const std::string& script) {
  std::vector<std::string> tokens;
  for (std::size_t start = 0; start < script.size();) {
    const std::size_t end = EndOfToken(script, start);
    tokens.push_back(script.substr(start, end - start));
    start = end;
  }
  return tokens;
}

std::string CScriptMutator::Mutate(const std::string& script) {
  std::vector<std::string> tokens = ToTokens(script);
  for (std::size_t n = 1 + Draw(4); n > 0 && !tokens.empty(); --n) {
    MutateOnce(tokens);
  }
  std::string text;
  for (const std::string& token : tokens) {
    text += token;
  }
  return text;
}

void CScriptMutator::MutateOnce(std::vector<std::string>& tokens) {
  // blanks and comments change nothing
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (std::isspace(static_cast<unsigned char>(tokens[i][0])) == 0 &&
        tokens[i].compare(0, 2, "--") != 0) {
      places.push_back(i);
    }
  }
  if (places.empty()) {
    return;
  }
  const std::size_t place = places[Draw(places.size())];
  const std::size_t other = places[Draw(places.size())];
  switch (Draw(5)) {
    case 0:
      tokens[place] = " ";
      break;
    case 1:
      tokens[place] += " " + tokens[place];
      break;
    case 2:
      std::swap(tokens[place], tokens[other]);
      break;
    case 3:
      tokens[place] = tokens[other];
      break;
    default:
      tokens[place] = std::string(" ") + kHostile[Draw(kHostile.size())] + " ";
  }
}

std::string RandomCallsScript(const std::string& table, std::uint32_t seed, int calls) {
  return "local table_name, state, calls = '" + table + "', " + std::to_string(seed) + ", " +
         std::to_string(calls) + R"(
-- numbers from 1 to n
local function draw(n)
  state = (state * 6364136223846793005 + 1442695040888963407)
  return (state >> 33) % n + 1
end
local deep = {}
do local t = deep for i = 1, 40 do t[1] = {} t = t[1] end end
local shared = {}
for i = 1, 28 do shared = {shared, shared} end
local cycle = {}
cycle[1] = cycle
local function fail() error('mine') end
local values = {0, -1, 1, 2, 3, 1.5, 0.25, 255, 256, -0.0, 1e308, -1e308, 1e-320, 1e10,
  math.huge, -math.huge, 0/0, 1 << 62, math.mininteger, math.maxinteger, true, false,
  '', 'red', 'fb', 'x', '1,2,3', '1,2,3,4', 'nan', '\0', ('x'):rep(10000), ('\xff'):rep(50),
  {}, {1, 2, 3}, {1, 2, 256}, {1, 2}, {1, nil, 3}, {0/0}, {[1e9] = 1}, {x = 1, y = 2},
  deep, shared, cycle, setmetatable({}, {__len = fail, __index = fail}),
  setmetatable({}, {__len = function() return 1 << 60 end}),
  vector2(), vector2(1, 2), vector2(0/0, math.huge), vector3(), vector3(1, 2, 3),
  vector3(1e308, -1e308, 0/0), quaternion(), quaternion(0, 0, 0, 0), quaternion(0/0, 1, 2, 3),
  print, fail, coroutine.create(print), io.stdout, _G}
local functions = {}
local function collect(path, t, depth)
  for name, value in pairs(t) do
    if type(value) == 'function' and not skipped[path .. '.' .. tostring(name)] then
      functions[#functions + 1] = {path .. '.' .. tostring(name), value}
    elseif type(value) == 'table' and depth < 4 then
      collect(path .. '.' .. tostring(name), value, depth + 1)
    end
  end
end
function call_all()
  if #functions == 0 then collect(table_name, _G[table_name], 0) end
  for i = 1, calls do
    local name, f = table.unpack(functions[draw(#functions)])
    local arguments = {}
    local n = draw(6) - 1
    for a = 1, n do
      local v = draw(#values + 1)
      arguments[a] = values[v]
    end
    local ok, message = pcall(f, table.unpack(arguments, 1, n))
    if not ok and not (type(message) == 'string' and message:find(name, 1, true)) then
      error('an error of ' .. name .. ' does not name it: ' .. tostring(message))
    end
  end
end
skipped = {}
)";
}

}  // namespace argos
