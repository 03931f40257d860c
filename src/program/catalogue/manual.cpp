#include <argos3/program/catalogue/manual.h>

#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/program/catalogue/text_layout.h>

#include <algorithm>
#include <regex>
#include <sstream>

namespace argos {

namespace {

// "x,y,z", m, default "0,0,0": of the centre
SAttributeText Parsed(const std::string& text) {
  static const std::string kWord =
      "(?:[kcm]?[gmsN]|rad|degrees|pixels|bytes|ticks|MiB|Hz|MHz|V|ms)(?:\\^[0-9])?";
  static const std::regex kUnit("^(?:\"[^\"]*\", )?(" + kWord + "(?:(?:/| | per | or )" + kWord +
                                ")*)(?:[,.:;].*)?$");
  static const std::regex kDefault(
      "[Dd]efault:? (?:\"([^\"]*)\"|([^:;,]*?)(?:[:;,]|\\.(?= |$)|$))|\"?([^ \",;]+)\"? "
      "\\(default\\)|\"?([^ \",;]+)\"?, the default");
  SAttributeText parsed{"", "", text};
  std::smatch match;
  if (std::regex_match(text, match, kUnit)) {
    parsed.Unit = match[1];
  }
  if (std::regex_search(text, match, kDefault)) {
    for (size_t i = 1; i < match.size(); ++i) {
      parsed.Default += match[i];
    }
  }
  return parsed;
}

void CollectTags(TConfigurationNode& element, std::set<std::string>& tags) {
  tags.insert(element.Value());
  TConfigurationNodeIterator it;
  for (it = it.begin(&element); it != it.end(); ++it) {
    CollectTags(*it, tags);
  }
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
      continue;  // it has dots, or is prose
    }
    TConfigurationNodeIterator it;
    for (it = it.begin(&document->GetRoot()); it != it.end(); ++it) {
      m_examples.push_back(*it);
      CollectTags(*it, m_tags);
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

// names are those of attributes, "tag@attribute", or "@attribute" of the tag before it
void CManual::NoteRow(const std::string& names, const std::string& text) {
  if (text.empty() || names.find_first_of("<>=\"") != std::string::npos) {
    return;
  }
  std::istringstream list(names);
  std::string tag;
  for (std::string name; std::getline(list, name, ',');) {
    name = name.substr(IndentOf(name));
    if (name.empty() || name.find(' ') != std::string::npos) {
      continue;
    }
    const size_t at = name.find('@');
    if (at == std::string::npos) {
      m_rows.push_back({"", name.substr(name.rfind('/') + 1), text});
      continue;
    }
    if (at > 0) {
      const std::string path = name.substr(0, at);
      tag = path.substr(path.rfind('/') + 1);
    }
    if (!tag.empty()) {
      m_rows.push_back({tag, name.substr(at + 1), text});
    }
  }
}

const CManual::SRow* CManual::FindRow(const std::string& tag, const std::string& name) const {
  const auto row = std::find_if(m_rows.begin(), m_rows.end(), [&](const SRow& other) {
    return other.Tag == tag && other.Name == name;
  });
  return row == m_rows.end() ? nullptr : &*row;
}

SAttributeText CManual::TextOfTag(const std::string& tag, const std::string& attribute) const {
  if (const SRow* const row = FindRow(tag, attribute)) {
    return Parsed(row->Text);
  }
  const std::regex word("\\b" + attribute + "\\b");
  for (const SRow& row : m_rows) {
    const bool isOfTag = row.Tag == tag || (row.Tag.empty() && row.Name == tag);
    if (isOfTag && std::regex_search(row.Text, word)) {
      return {"", "", row.Text};
    }
  }
  return {};
}

SAttributeText CManual::TextOf(const std::string& tag, const std::string& attribute) const {
  const SRow* const ofAny = FindRow(tag, attribute) == nullptr ? FindRow("", attribute) : nullptr;
  return ofAny == nullptr ? TextOfTag(tag, attribute) : Parsed(ofAny->Text);
}

}  // namespace argos
