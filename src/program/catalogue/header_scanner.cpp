#include <argos3/program/catalogue/header_scanner.h>

#include <argos3/core/utility/text/string_utilities.h>

#include <cctype>
#include <sstream>

namespace argos {

namespace {

bool IsBlank(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

std::string OnOneLine(const std::string& text) {
  std::string line;
  for (const char c : text) {
    if (!IsBlank(c)) {
      line += c;
    } else if (!line.empty() && line.back() != ' ') {
      line += ' ';
    }
  }
  if (!line.empty() && line.back() == ' ') {
    line.pop_back();
  }
  return line;
}

}  // namespace

std::string PlainComment(const std::string& comment) {
  std::istringstream lines(comment);
  std::string text;
  bool endsParagraph = true;
  for (std::string line; std::getline(lines, line);) {
    size_t begin = line.find_first_not_of(" \t/*<");
    begin = std::min(begin, line.size());
    line = OnOneLine(line.substr(begin));
    if (line.size() >= 2 && line.compare(line.size() - 2, 2, "*/") == 0) {
      line = OnOneLine(line.substr(0, line.size() - 2));
    }
    if (line.empty()) {
      text += endsParagraph ? "" : "\n";
      endsParagraph = true;
      continue;
    }
    const bool isTag = line[0] == '@';
    text += endsParagraph ? "" : isTag ? "\n" : " ";
    text += line;
    endsParagraph = false;
  }
  Replace(text, "@param[in] ", "");
  Replace(text, "@param[out] ", "");
  Replace(text, "@param ", "");
  Replace(text, "@p ", "");
  Replace(text, "@returns ", "returns ");
  Replace(text, "@return ", "returns ");
  Replace(text, "@throws CARGoSException", "throws CARGoSException");
  Replace(text, "@throws ", "throws ");
  Replace(text, "@brief ", "");
  return text;
}

bool CHeaderScanner::StartsWith(const char* word) const {
  return m_text.compare(m_at, std::char_traits<char>::length(word), word) == 0;
}

void CHeaderScanner::SkipBlanks() {
  while (m_at < m_text.size() && (IsBlank(m_text[m_at]) || m_text[m_at] == ';')) {
    ++m_at;
  }
}

void CHeaderScanner::SkipLine() {
  // lines that end with a backslash continue
  do {
    m_at = std::min(m_text.find('\n', m_at), m_text.size() - 1) + 1;
  } while (m_at >= 2 && m_text[m_at - 2] == '\\' && m_at < m_text.size());
}

bool CHeaderScanner::SkipComment() {
  if (StartsWith("//")) {
    SkipLine();
    return true;
  }
  if (!StartsWith("/*")) {
    return false;
  }
  const size_t end = std::min(m_text.find("*/", m_at), m_text.size() - 2) + 2;
  if (StartsWith("/**")) {
    m_comment = PlainComment(m_text.substr(m_at, end - m_at));
  }
  m_at = end;
  return true;
}

// @return the place behind the bracket that closes the one at @p begin
std::size_t CHeaderScanner::EndOfBrackets(std::size_t begin) const {
  int depth = 0;
  for (size_t at = begin; at < m_text.size(); ++at) {
    const char c = m_text[at];
    if (m_text.compare(at, 2, "//") == 0) {
      at = std::min(m_text.find('\n', at), m_text.size());
    } else if (m_text.compare(at, 2, "/*") == 0) {
      at = std::min(m_text.find("*/", at), m_text.size()) + 1;
    } else if (c == '"' || c == '\'') {
      for (++at; at < m_text.size() && m_text[at] != c; ++at) {
        at += m_text[at] == '\\' ? 1 : 0;
      }
    } else if (c == '{' || c == '(' || c == '[') {
      ++depth;
    } else if ((c == '}' || c == ')' || c == ']') && --depth == 0) {
      return at + 1;
    }
  }
  return m_text.size();
}

void CHeaderScanner::ReadDeclaration() {
  std::string code;
  while (m_at < m_text.size() && m_text[m_at] != ';') {
    const char c = m_text[m_at];
    if (StartsWith("//") || StartsWith("/*")) {
      const std::string comment = m_comment;
      SkipComment();
      m_comment = comment;
    } else if (c == '(') {
      const size_t end = EndOfBrackets(m_at);
      code += m_text.substr(m_at, end - m_at);
      m_at = end;
    } else if (c == '{') {
      const size_t end = EndOfBrackets(m_at);
      m_body = m_text.substr(m_at + 1, end - m_at - 2);
      m_at = end;
      break;
    } else {
      code += c;
      ++m_at;
    }
  }
  m_code = OnOneLine(code);
}

void CHeaderScanner::ReadCommentBehind() {
  size_t at = m_at;
  while (at < m_text.size() && (m_text[at] == ';' || m_text[at] == ' ')) {
    ++at;
  }
  if (m_text.compare(at, 4, "/**<") == 0) {
    m_at = at;
    SkipComment();
  }
}

bool CHeaderScanner::Next() {
  m_label.clear();
  m_code.clear();
  m_body.clear();
  m_comment.clear();
  for (SkipBlanks(); m_at < m_text.size(); SkipBlanks()) {
    if (m_text[m_at] == '#') {
      SkipLine();
      m_comment.clear();
      continue;
    }
    if (SkipComment()) {
      continue;
    }
    for (const char* const label : {"public:", "protected:", "private:"}) {
      if (StartsWith(label)) {
        m_label = std::string(label, std::char_traits<char>::length(label) - 1);
        m_at += m_label.size() + 1;
        return true;
      }
    }
    ReadDeclaration();
    ReadCommentBehind();
    return true;
  }
  return false;
}

}  // namespace argos
