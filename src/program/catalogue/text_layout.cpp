#include <argos3/program/catalogue/text_layout.h>

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <vector>

namespace argos {

namespace {

// column of texts in tables with very long names
constexpr std::size_t kMaxColumn = 40;
constexpr std::size_t kShallowIndent = 8;

using TLines = std::vector<std::string>;

bool IsItem(const std::string& line) {
  return line.rfind("- ", 0) == 0;
}

// XML, and what is narrow enough
bool IsKept(const TLines& lines) {
  const std::size_t indent = IndentOf(lines.front());
  return (indent > 0 && lines.front().compare(indent, 1, "<") == 0) ||
         std::none_of(lines.begin(), lines.end(),
                      [](const std::string& line) { return line.size() > kTextWidth; });
}

// a paragraph, an item of a list, or a row of a table, "  name    text", with the lines that
// continue it
std::string WrapUnit(const std::string& first, const std::string& rest) {
  const std::size_t indent = IndentOf(first);
  std::string text = rest.empty() ? "" : " ";
  text += rest;
  if (indent == 0) {
    return Wrapped(first + text, 0, IsItem(first) ? 2 : 0);
  }
  const std::size_t gap = first.find("  ", indent);
  if (gap == std::string::npos) {
    return first + '\n' + (rest.empty() ? "" : Wrapped(rest, indent + 6));
  }
  const std::size_t column = std::min(first.find_first_not_of(' ', gap), first.size());
  const std::string described = first.substr(column) + text;
  if (column > kMaxColumn) {
    return first.substr(0, gap) + '\n' + Wrapped(described, kShallowIndent);
  }
  return first.substr(0, column) + Wrapped(described, column).substr(column);
}

// lines that are all indented, or none of them
std::string WrapLines(const TLines& lines) {
  std::string text;
  std::size_t i = 0;
  while (i < lines.size()) {
    const std::string& first = lines[i];
    std::string rest;
    for (++i; i < lines.size() && !IsItem(lines[i]) &&
              (IndentOf(first) == 0 || IndentOf(lines[i]) > IndentOf(first));
         ++i) {
      rest += rest.empty() ? "" : " ";
      rest += lines[i].substr(IndentOf(lines[i]));
    }
    text += WrapUnit(first, rest);
  }
  return text;
}

}  // namespace

std::size_t IndentOf(const std::string& line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

std::string Wrapped(const std::string& text, std::size_t indent, std::size_t hanging) {
  std::string wrapped;
  std::istringstream lines(text);
  std::string start(indent, ' ');
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string current;
    for (std::string word; words >> word;) {
      if (!current.empty() && current.size() + 1 + word.size() > kTextWidth) {
        wrapped += current + '\n';
        start.resize(indent + hanging, ' ');
        current.clear();
      }
      current += (current.empty() ? start : " ") + word;
    }
    wrapped += current + '\n';
    start.resize(indent + hanging, ' ');
  }
  return wrapped;
}

std::string WrappedManual(const std::string& manual) {
  std::string text;
  TLines run;
  const auto finish = [&] {
    if (!run.empty() && IsKept(run)) {
      text += fmt::format("{}\n", fmt::join(run, "\n"));
    } else if (!run.empty()) {
      text += WrapLines(run);
    }
    run.clear();
  };
  std::istringstream lines(manual);
  for (std::string line; std::getline(lines, line);) {
    const bool isEmpty = IndentOf(line) == line.size();
    const bool isOther = !run.empty() && (IndentOf(line) > 0) != (IndentOf(run.back()) > 0);
    // the lines of an item may be indented
    if (isEmpty || (isOther && !IsItem(run.front()))) {
      finish();
    }
    if (isEmpty) {
      text += '\n';
    } else {
      run.push_back(line);
    }
  }
  finish();
  return text;
}

}  // namespace argos
