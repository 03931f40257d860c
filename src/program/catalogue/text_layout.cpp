#include <argos3/program/catalogue/text_layout.h>

#include <algorithm>
#include <sstream>
#include <vector>

namespace argos {

namespace {

// where texts begin in tables with very long names
constexpr std::size_t kMostIndent = 40;
constexpr std::size_t kShallowIndent = 8;

std::size_t IndentOf(const std::string& line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

// lines until the next empty one
using TBlock = std::vector<std::string>;

bool IsXml(const TBlock& block) {
  const std::size_t indent = IndentOf(block.front());
  return indent > 0 && block.front().compare(indent, 1, "<") == 0;
}

bool IsWide(const TBlock& block) {
  return std::any_of(block.begin(), block.end(),
                     [](const std::string& line) { return line.size() > kTextWidth; });
}

// "name    text": the column of the text; 0 if there is none
std::size_t TextColumn(const std::string& line) {
  const std::size_t gap = line.find("  ", IndentOf(line));
  return gap == std::string::npos ? 0 : std::min(line.find_first_not_of(' ', gap), line.size());
}

void WrapRow(const std::string& row, const std::string& more, std::string& text) {
  const std::size_t column = TextColumn(row);
  const std::size_t indent = IndentOf(row);
  if (column == 0) {
    text += row + '\n';
    text += more.empty() ? "" : Wrapped(more, indent + 6);
    return;
  }
  std::string rest = row.substr(column);
  rest += more.empty() ? "" : " ";
  rest += more;
  if (column > kMostIndent) {
    const std::string name = row.substr(0, row.find_last_not_of(' ', column - 1) + 1);
    text += name + '\n' + Wrapped(rest, kShallowIndent);
  } else {
    text += row.substr(0, column) + Wrapped(rest, column).substr(column);
  }
}

// rows, each followed by lines that are indented more
void WrapTable(const TBlock& block, std::string& text) {
  std::size_t i = 0;
  while (i < block.size()) {
    const std::string& row = block[i];
    std::string more;
    for (++i; i < block.size() && IndentOf(block[i]) > IndentOf(row); ++i) {
      more += more.empty() ? "" : " ";
      more += block[i].substr(IndentOf(block[i]));
    }
    WrapRow(row, more, text);
  }
}

void WrapParagraph(const TBlock& block, std::string& text) {
  std::string paragraph;
  const auto finish = [&] {
    const bool isItem = paragraph.rfind("- ", 0) == 0;
    text += paragraph.empty() ? "" : Wrapped(paragraph, 0, isItem ? 2 : 0);
    paragraph.clear();
  };
  for (const std::string& line : block) {
    if (line.rfind("- ", 0) == 0) {
      finish();
    }
    paragraph += paragraph.empty() ? "" : " ";
    paragraph += line.substr(IndentOf(line));
  }
  finish();
}

// all lines indented, or none
void WrapRun(const TBlock& block, std::string& text) {
  if (IsXml(block) || !IsWide(block)) {
    for (const std::string& line : block) {
      text += line + '\n';
    }
  } else if (IndentOf(block.front()) == 0) {
    WrapParagraph(block, text);
  } else {
    WrapTable(block, text);
  }
}

void WrapBlock(const TBlock& block, std::string& text) {
  if (block.front().rfind("- ", 0) == 0 && IsWide(block)) {
    WrapParagraph(block, text);
    return;
  }
  const auto isIndented = [](const std::string& line) { return line.front() == ' '; };
  auto begin = block.begin();
  while (begin != block.end()) {
    const bool first = isIndented(*begin);
    const auto end = std::find_if(
        begin, block.end(), [&](const std::string& line) { return isIndented(line) != first; });
    WrapRun(TBlock(begin, end), text);
    begin = end;
  }
}

}  // namespace

std::string Wrapped(const std::string& text, std::size_t indent, std::size_t hanging) {
  std::string wrapped;
  std::istringstream lines(text);
  bool isFirst = true;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string current;
    for (std::string word; words >> word;) {
      const std::string start = std::string(indent + (isFirst ? 0 : hanging), ' ');
      if (current.empty()) {
        current = start + word;
      } else if (current.size() + 1 + word.size() <= kTextWidth) {
        current += ' ' + word;
      } else {
        wrapped += current + '\n';
        isFirst = false;
        current = std::string(indent + hanging, ' ') + word;
      }
    }
    wrapped += current + '\n';
    isFirst = false;
  }
  return wrapped;
}

std::string WrappedManual(const std::string& manual) {
  std::string text;
  TBlock block;
  const auto finish = [&] {
    if (!block.empty()) {
      WrapBlock(block, text);
      block.clear();
    }
  };
  std::istringstream lines(manual);
  for (std::string line; std::getline(lines, line);) {
    if (IndentOf(line) == line.size()) {
      finish();
      text += '\n';
    } else {
      block.push_back(line);
    }
  }
  finish();
  return text;
}

}  // namespace argos
