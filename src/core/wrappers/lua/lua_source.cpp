#include <argos3/core/wrappers/lua/lua_source.h>

#include <argos3/core/utility/files/input_file.h>
#include <argos3/core/wrappers/lua/lua_headers.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

namespace argos {

namespace {

struct SToken {
  enum class EKind { Name, Text, Symbol };
  EKind Kind = EKind::Symbol;
  std::string_view Text;  // contents of a text, without its quotation marks
};

bool IsWordPart(char c) {
  return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0;
}

/** Divides a text into names, texts and symbols; comments and blanks are left out. */
class CTokenizer {
 public:
  explicit CTokenizer(std::string_view text) : m_text(text) {}

  std::vector<SToken> Run() {
    std::vector<SToken> tokens;
    while (m_at < m_text.size()) {
      if (std::isspace(static_cast<unsigned char>(m_text[m_at])) != 0) {
        ++m_at;
      } else if (m_text.substr(m_at, 2) == "--") {
        SkipComment();
      } else {
        tokens.push_back(ReadToken());
      }
    }
    return tokens;
  }

 private:
  // @return the level of the long bracket at a place: 0 of "[[", 1 of "[=["; -1 if there is none
  int LevelAt(std::size_t at) const {
    if (at >= m_text.size() || m_text[at] != '[') {
      return -1;
    }
    const std::size_t end = std::min(m_text.find_first_not_of('=', at + 1), m_text.size());
    return end < m_text.size() && m_text[end] == '[' ? static_cast<int>(end - at) - 1 : -1;
  }

  std::string_view ReadLongText(int level) {
    const std::size_t start = m_at + static_cast<std::size_t>(level) + 2;
    const std::string close = ']' + std::string(static_cast<std::size_t>(level), '=') + ']';
    const std::size_t end = std::min(m_text.find(close, start), m_text.size());
    m_at = std::min(end + close.size(), m_text.size());
    return m_text.substr(start, end - start);
  }

  std::string_view ReadQuotedText() {
    const char mark = m_text[m_at];
    const std::size_t start = ++m_at;
    while (m_at < m_text.size() && m_text[m_at] != mark && m_text[m_at] != '\n') {
      m_at += m_text[m_at] == '\\' ? 2 : 1;
    }
    const std::size_t end = std::min(m_at, m_text.size());
    m_at = end + 1;
    return m_text.substr(start, end - start);
  }

  void SkipComment() {
    m_at += 2;
    const int level = LevelAt(m_at);
    if (level >= 0) {
      ReadLongText(level);
    } else {
      m_at = std::min(m_text.find('\n', m_at), m_text.size());
    }
  }

  SToken ReadToken() {
    const char first = m_text[m_at];
    if (IsWordPart(first)) {
      const std::size_t start = m_at;
      while (m_at < m_text.size() && IsWordPart(m_text[m_at])) {
        ++m_at;
      }
      const bool isNumber = std::isdigit(static_cast<unsigned char>(first)) != 0;
      return {isNumber ? SToken::EKind::Symbol : SToken::EKind::Name,
              m_text.substr(start, m_at - start)};
    }
    if (first == '"' || first == '\'') {
      return {SToken::EKind::Text, ReadQuotedText()};
    }
    if (const int level = LevelAt(m_at); level >= 0) {
      return {SToken::EKind::Text, ReadLongText(level)};
    }
    // "..", "==", "~=" and the like are one symbol each
    const std::size_t start = m_at++;
    const std::string_view followers = first == '.' ? "." : "=";
    if (std::string_view(".=~<>").find(first) != std::string_view::npos) {
      m_at = std::min(m_text.find_first_not_of(followers, m_at), m_text.size());
    }
    return {SToken::EKind::Symbol, m_text.substr(start, m_at - start)};
  }

  std::string_view m_text;
  std::size_t m_at = 0;
};

/** Collects what one file mentions. */
class CReader {
 public:
  CReader(SLuaSource& source, const std::string& folder) : m_source(source), m_folder(folder) {}

  void ReadText(const std::string& text) {
    if (text.rfind(LUA_SIGNATURE, 0) == 0) {
      m_source.UsesAllParameters = true;
      return;
    }
    const std::vector<SToken> tokens = CTokenizer(text).Run();
    m_tokens = &tokens;
    m_aliases = {"params"};
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      if (tokens[i].Kind == SToken::EKind::Text) {
        m_source.Words.emplace(tokens[i].Text);
      } else if (tokens[i].Kind == SToken::EKind::Name) {
        ReadName(i);
      }
    }
  }

 private:
  /** @return the token at a place; an empty symbol outside of the text. */
  SToken At(std::size_t i) const { return i < m_tokens->size() ? (*m_tokens)[i] : SToken(); }
  bool IsSymbol(std::size_t i, std::string_view symbol) const {
    return At(i).Kind == SToken::EKind::Symbol && At(i).Text == symbol;
  }
  bool IsName(std::size_t i, std::string_view name) const {
    return At(i).Kind == SToken::EKind::Name && At(i).Text == name;
  }
  bool IsField(std::size_t i) const {
    return i > 0 && (IsSymbol(i - 1, ".") || IsSymbol(i - 1, ":"));
  }

  void ReadName(std::size_t i) {
    const std::string name(At(i).Text);
    ++m_source.NumUses[name];
    if (IsField(i)) {
      m_source.Words.insert(name);
    } else if (name == "require" || name == "dofile" || name == "loadfile" || name == "load") {
      FollowFile(i);
    }
    if (name == "params" || (m_aliases.count(name) > 0 && !IsField(i))) {
      ReadParameters(i);
    }
  }

  // a use of the table of parameters, or of a variable that refers to it
  void ReadParameters(std::size_t i) {
    const bool isField = IsSymbol(i + 1, ".") && At(i + 2).Kind == SToken::EKind::Name;
    const bool isConstantIndex =
        IsSymbol(i + 1, "[") && At(i + 2).Kind == SToken::EKind::Text && IsSymbol(i + 3, "]");
    if (isField || isConstantIndex) {
      m_source.Parameters.emplace(At(i + 2).Text);
    } else if (IsSymbol(i + 1, "[")) {
      m_source.PassesParameters = true;
    } else if (!IsSymbol(i + 1, "=")) {
      ReadValue(i);
    }
  }

  // the table itself is a value: local p = robot.params, pairs(robot.params), f(robot.params)
  void ReadValue(std::size_t i) {
    while (i >= 2 && IsSymbol(i - 1, ".") && At(i - 2).Kind == SToken::EKind::Name) {
      i -= 2;
    }
    if (i < 2) {
      return;
    }
    const bool isVisited = IsName(i - 2, "pairs") || IsName(i - 2, "next");
    if (isVisited && (IsSymbol(i - 1, "(") || IsSymbol(i - 1, ","))) {
      m_source.UsesAllParameters = true;
    } else if (IsSymbol(i - 1, "=") && At(i - 2).Kind == SToken::EKind::Name && !IsField(i - 2) &&
               !(i >= 3 && IsSymbol(i - 3, ","))) {
      m_aliases.emplace(At(i - 2).Text);
    } else {
      m_source.PassesParameters = true;
    }
  }

  // the name at a place is a function that runs code from elsewhere
  void FollowFile(std::size_t i) {
    const bool isCall = At(i + 1).Kind == SToken::EKind::Text || IsSymbol(i + 1, "(");
    const SToken argument = IsSymbol(i + 1, "(") ? At(i + 2) : At(i + 1);
    if (!isCall) {
      return;
    }
    const std::string name(argument.Text);
    bool isRead = argument.Kind == SToken::EKind::Text && !IsName(i, "load");
    if (isRead && IsName(i, "require")) {
      std::string path = name;
      std::replace(path.begin(), path.end(), '.', '/');
      isRead = m_read.count(name) > 0 || ReadFile(m_folder + '/' + path + ".lua") ||
               ReadFile(m_folder + '/' + path + "/init.lua") || ReadFile(path + ".lua") ||
               ReadFile(path + "/init.lua");
    } else if (isRead) {
      isRead = m_read.count(name) > 0 || ReadFile(name);
    }
    m_read.insert(name);
    m_source.UsesAllParameters = m_source.UsesAllParameters || !isRead;
  }

  bool ReadFile(const std::string& path) {
    std::string text;
    std::string problem;
    if (!ReadInputFile(path, text, problem)) {
      return false;
    }
    if (m_read.insert(path).second) {
      const std::vector<SToken>* const tokens = m_tokens;
      const std::set<std::string> aliases = m_aliases;
      ReadText(text);
      m_tokens = tokens;
      m_aliases = aliases;
    }
    return true;
  }

  SLuaSource& m_source;
  const std::string& m_folder;
  std::set<std::string> m_read;  // modules and files
  std::set<std::string> m_aliases;  // variables that refer to the table
  const std::vector<SToken>* m_tokens = nullptr;
};

}  // namespace

bool SLuaSource::MayUseParameter(const std::string& name) const {
  return UsesAllParameters || Parameters.count(name) > 0 ||
         (PassesParameters && Words.count(name) > 0);
}

std::size_t SLuaSource::CountUses(const std::string& name) const {
  const auto found = NumUses.find(name);
  return found != NumUses.end() ? found->second : 0;
}

SLuaSource SLuaSource::Read(const std::string& text, const std::string& folder) {
  SLuaSource source;
  CReader(source, folder).ReadText(text);
  return source;
}

}  // namespace argos
