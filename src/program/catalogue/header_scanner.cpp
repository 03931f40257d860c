#include <argos3/program/catalogue/header_scanner.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <sstream>

namespace argos {

namespace {

std::string OnOneLine(const std::string& text) {
  std::istringstream words(text);
  std::string line;
  for (std::string word; words >> word;) {
    line += (line.empty() ? "" : " ") + word;
  }
  return line;
}

// the place behind what begins at a place: a comment, a string, or brackets with their contents
size_t EndOf(const std::string& text, size_t begin) {
  const auto behind = [&text](const char* sign, size_t from) {
    const size_t at = text.find(sign, from);
    return at == std::string::npos ? text.size() : at + std::char_traits<char>::length(sign);
  };
  const char c = text[begin];
  if (text.compare(begin, 2, "//") == 0) {
    return behind("\n", begin);
  }
  if (text.compare(begin, 2, "/*") == 0) {
    return behind("*/", begin + 2);
  }
  if (c == '"' || c == '\'') {
    size_t at = begin + 1;
    while (at < text.size() && text[at] != c) {
      at += text[at] == '\\' ? 2 : 1;
    }
    return std::min(at + 1, text.size());
  }
  if (c != '{' && c != '(' && c != '[') {
    return begin + 1;
  }
  size_t at = begin + 1;
  while (at < text.size() && text[at] != '}' && text[at] != ')' && text[at] != ']') {
    at = EndOf(text, at);
  }
  return std::min(at + 1, text.size());
}

// finds the place behind the line, and those that continue it after a backslash
size_t EndOfLine(const std::string& text, size_t begin) {
  size_t end = text.find('\n', begin);
  while (end != std::string::npos && text[end - 1] == '\\') {
    end = text.find('\n', end + 1);
  }
  return end == std::string::npos ? text.size() : end + 1;
}

}  // namespace

std::string PlainComment(const std::string& comment) {
  static const std::regex kNoise("@(?:param(?:\\[\\w+\\])?|p|brief) ");
  static const std::regex kTags("@(return|throw)s? ");
  std::istringstream lines(comment);
  std::string text;
  bool endsParagraph = true;
  for (std::string line; std::getline(lines, line);) {
    line = OnOneLine(line.substr(std::min(line.find_first_not_of(" \t/*<"), line.size())));
    if (line.size() >= 2 && line.compare(line.size() - 2, 2, "*/") == 0) {
      line = OnOneLine(line.substr(0, line.size() - 2));
    }
    if (line.empty()) {
      text += endsParagraph ? "" : "\n";
      endsParagraph = true;
    } else {
      if (!endsParagraph) {
        text += line[0] == '@' ? '\n' : ' ';
      }
      text += line;
      endsParagraph = false;
    }
  }
  return std::regex_replace(std::regex_replace(text, kNoise, ""), kTags, "$1s ");
}

std::vector<SHeaderItem> SplitDeclarations(const std::string& text) {
  std::vector<SHeaderItem> items;
  SHeaderItem item;
  const auto finish = [&] {
    item.Code = OnOneLine(item.Code);
    if (!item.Code.empty()) {
      items.push_back(item);
    }
    item = SHeaderItem();
  };
  for (size_t at = 0, end = 0; at < text.size(); at = end) {
    const char c = text[at];
    const bool isStart = item.Code.empty();
    end = EndOf(text, at);
    if (c == '#' && isStart) {
      item.Comment.clear();
      end = EndOfLine(text, at);
    } else if (text.compare(at, 2, "//") == 0 || text.compare(at, 2, "/*") == 0) {
      const bool isBehind = text.compare(at, 4, "/**<") == 0;
      if (isStart && text.compare(at, 3, "/**") == 0 && !(isBehind && items.empty())) {
        (isBehind ? items.back() : item).Comment = PlainComment(text.substr(at, end - at));
      }
    } else if (c == '{') {
      item.Body = text.substr(at + 1, end - at - 2);
      finish();
    } else if (c == ';' || (c == ':' && (item.Code == "public" || item.Code == "protected" ||
                                         item.Code == "private"))) {
      finish();
    } else if (!isStart || std::isspace(static_cast<unsigned char>(c)) == 0) {
      item.Code += text.substr(at, end - at);
    }
  }
  finish();
  return items;
}

}  // namespace argos
