#include <argos3/program/catalogue/manual.h>

#include <argos3/core/utility/configuration/configuration_document.h>

#include <sstream>

namespace argos {

namespace {

size_t IndentOf(const std::string& line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

}  // namespace

CManual::CManual(const std::string& text) {
  ReadExamples(text);
  ReadTables(text);
}

CManual::CManual(CManual&&) noexcept = default;
CManual::~CManual() = default;

void CManual::ReadExamples(const std::string& text) {
  std::vector<std::string> blocks;
  std::istringstream lines(text);
  bool inExample = false;
  for (std::string line; std::getline(lines, line);) {
    const size_t indent = IndentOf(line);
    const bool begins = !inExample && indent >= 2 && line.compare(indent, 1, "<") == 0;
    if (begins) {
      blocks.emplace_back();
    }
    inExample = indent < line.size() && (inExample || begins);
    if (inExample) {
      blocks.back() += line + '\n';
    }
  }
  for (const std::string& block : blocks) {
    auto document = std::make_unique<CConfigurationDocument>();
    try {
      document->Parse("<example>" + block + "</example>", "(example)");
    } catch (const CARGoSException&) {
      continue;  // with dots in it, or prose
    }
    TConfigurationNodeIterator it;
    for (it = it.begin(&document->GetRoot()); it != it.end(); ++it) {
      m_examples.push_back(*it);
    }
    m_documents.push_back(std::move(document));
  }
}

// a row is "  name, other  text", and the lines below it that are indented more
void CManual::ReadTables(const std::string& text) {
  std::istringstream lines(text);
  std::string names;
  std::string row;
  size_t rowIndent = 0;
  const auto finish = [&] {
    NoteRow(names, row);
    names.clear();
    row.clear();
  };
  for (std::string line; std::getline(lines, line);) {
    const size_t indent = IndentOf(line);
    if (indent == line.size() || indent < 2) {
      finish();
      continue;
    }
    if (!names.empty() && indent > rowIndent) {
      row += row.empty() ? "" : " ";
      row += line.substr(indent);
      continue;
    }
    finish();
    const size_t gap = line.find("  ", indent);
    names = line.substr(indent, gap == std::string::npos ? gap : gap - indent);
    rowIndent = indent;
    if (gap != std::string::npos) {
      row = line.substr(std::min(line.find_first_not_of(' ', gap), line.size()));
    }
  }
  finish();
}

void CManual::NoteRow(const std::string& names, const std::string& text) {
  if (text.empty() || names.find_first_of("<>=\"") != std::string::npos) {
    return;
  }
  std::istringstream list(names);
  std::string element;
  for (std::string name; std::getline(list, name, ',');) {
    name = name.substr(IndentOf(name));
    if (name.empty() || name.find(' ') != std::string::npos) {
      continue;
    }
    const size_t at = name.find('@');
    if (at == 0) {
      name = element + name;
    } else if (at != std::string::npos) {
      const size_t slash = name.rfind('/', at);
      name = slash == std::string::npos ? name : name.substr(slash + 1);
      element = name.substr(0, name.find('@'));
    }
    m_texts.emplace(name, text);
  }
}

std::string CManual::TextOf(const std::string& tag, const std::string& attribute) const {
  const auto exact = m_texts.find(tag + '@' + attribute);
  if (exact != m_texts.end()) {
    return exact->second;
  }
  const auto found = m_texts.find(attribute);
  return found == m_texts.end() ? "" : found->second;
}

}  // namespace argos
