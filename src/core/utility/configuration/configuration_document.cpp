#include <argos3/core/utility/configuration/configuration_document.h>

#include <argos3/core/utility/configuration/attribute_search.h>
#include <argos3/core/utility/configuration/configuration_error.h>
#include <argos3/core/utility/configuration/configuration_path.h>
#include <argos3/core/utility/configuration/configuration_store.h>
#include <argos3/core/utility/configuration/xml_text.h>
#include <argos3/core/utility/files/file_replacement.h>
#include <argos3/core/utility/files/input_file.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <cstddef>
#include <vector>

namespace argos {

// construction and destruction

CConfigurationDocument::CConfigurationDocument()
    : m_store(std::make_shared<CConfigurationStore>("(empty document)")) {}

CConfigurationDocument::CConfigurationDocument(CConfigurationDocument&&) noexcept = default;

CConfigurationDocument& CConfigurationDocument::operator=(CConfigurationDocument&&) noexcept =
    default;

CConfigurationDocument::~CConfigurationDocument() = default;

// reading and writing

namespace {

std::string Describe(tinyxml2::XMLError error) {
  switch (error) {
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return "the document is empty, expected an XML document";
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return "this closing tag does not match the element that is open";
    case tinyxml2::XML_ERROR_PARSING_ELEMENT:
      return "this tag is malformed or not closed, expected <name attribute=\"value\">";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "an attribute of this element is malformed or given twice, expected name=\"value\"";
    case tinyxml2::XML_ERROR_PARSING_TEXT:
      return "this text is not followed by a tag";
    case tinyxml2::XML_ERROR_PARSING_CDATA:
      return "this CDATA section is not closed, expected \"]]>\"";
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
      return "this comment is not closed, expected \"-->\"";
    case tinyxml2::XML_ERROR_PARSING_DECLARATION:
      return "this declaration is misplaced or not closed, expected \"?>\" at the top of the file";
    case tinyxml2::XML_ERROR_PARSING_UNKNOWN:
      return "this markup is not closed, expected \">\"";
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return "elements are nested too deeply";
    default:
      return std::string("it cannot be parsed as XML (") +
             tinyxml2::XMLDocument::ErrorIDToName(error) + ")";
  }
}

[[noreturn]] void ThrowMalformed(const std::string& name, int line, const std::string& what) {
  THROW_CONFIGURATION_ERROR(LocationText(name, line) << ": not well-formed XML: " << what);
}

void ThrowIfFault(const std::string& name, const SXmlFault& fault) {
  if (!fault.Text.empty()) {
    ThrowMalformed(name, fault.Line, fault.Text);
  }
}

// the parser accepts several root elements and text outside the root element
void CheckSingleRoot(tinyxml2::XMLDocument& xml, const std::string& name) {
  const tinyxml2::XMLElement* root = xml.RootElement();
  if (root == nullptr) {
    ThrowMalformed(name, 0, "the document has no element");
  }
  for (const auto* node = xml.FirstChild(); node != nullptr; node = node->NextSibling()) {
    const bool isExtraElement = node->ToElement() != nullptr && node != root;
    if (isExtraElement || node->ToText() != nullptr) {
      ThrowMalformed(
          name, node->GetLineNum(),
          (isExtraElement ? '<' + std::string(node->Value()) + "> is" : std::string("text is")) +
              " outside the root element <" + root->Value() + ">");
    }
  }
}

tinyxml2::XMLError ParseFast(tinyxml2::XMLDocument& document, const std::string& text) {
  const CAttributeSearch fast;
  return document.Parse(text.data(), text.size());
}

}  // namespace

void CConfigurationDocument::Parse(const std::string& xml, const std::string& name) {
  auto store = std::make_shared<CConfigurationStore>(name);
  tinyxml2::XMLDocument& document = store->GetXml();
  std::string text = xml;
  ThrowIfFault(name, ConvertToUtf8(text));
  ThrowIfFault(name, FindXmlFault(text));
  const tinyxml2::XMLError error = ParseFast(document, text);
  if (error == tinyxml2::XML_ERROR_MISMATCHED_ELEMENT) {
    ThrowIfFault(name, FindMismatch(text));
  }
  if (error != tinyxml2::XML_SUCCESS) {
    ThrowMalformed(name, document.ErrorLineNum(), Describe(error));
  }
  CheckSingleRoot(document, name);
  m_store = std::move(store);
}

void CConfigurationDocument::LoadFile(const std::string& path) {
  std::string text;
  std::string problem;
  if (!ReadInputFile(path, text, problem)) {
    THROW_CONFIGURATION_ERROR("Cannot read the experiment file \"" << path << "\": " << problem);
  }
  Parse(text, path);
}

std::string CConfigurationDocument::ToText() const {
  if (m_store->GetXml().RootElement() == nullptr) {
    THROW_CONFIGURATION_ERROR("the document is empty: it has no text");
  }
  tinyxml2::XMLPrinter printer;
  m_store->GetXml().Print(&printer);
  return printer.CStr();
}

void CConfigurationDocument::SaveFile(const std::string& path) const {
  if (m_store->GetXml().RootElement() == nullptr) {
    THROW_CONFIGURATION_ERROR("Cannot save to \"" << path << "\": the document is empty");
  }
  std::string problem;
  if (!ReplaceFile(path, ToText(), problem)) {
    THROW_CONFIGURATION_ERROR("Cannot write the file \"" << path << "\": " << problem);
  }
}

void CConfigurationDocument::SetLasting() {
  m_store->SetLasting();
}

void CConfigurationDocument::SetLenient() {
  m_store->SetLenient();
}

CConfigurationNode& CConfigurationDocument::GetRoot() {
  CConfigurationNode* root = m_store->HandleOf(m_store->GetXml().RootElement());
  if (root == nullptr) {
    THROW_CONFIGURATION_ERROR("GetRoot() was called on a document that was not loaded");
  }
  return *root;
}

const std::string& CConfigurationDocument::GetName() const {
  return *m_store->GetName();
}

// modification, unread elements and attributes

std::string CConfigurationDocument::SetByPath(const std::string& path, const std::string& value,
                                              bool mustBeRead) {
  tinyxml2::XMLElement* root = m_store->GetXml().RootElement();
  if (root == nullptr) {
    THROW_CONFIGURATION_ERROR("Cannot set \"" << path << "\": the document is empty");
  }
  const CConfigurationPath parsed(path);
  std::string report;
  SConfigurationSetting setting{path, parsed.GetAttribute(), value, {}};
  for (tinyxml2::XMLElement* element : parsed.Find(*root)) {
    const char* previous = element->Attribute(parsed.GetAttribute().c_str());
    const SConfigurationEntry& entry = m_store->EntryOf(*element);
    report += report.empty() ? "" : "\n";
    report += LocationText(*entry.File, entry.Line) + ": <" + element->Value() + "> " +
              parsed.GetAttribute() + "=\"" + value + "\" (" +
              (previous != nullptr ? std::string("was \"") + previous + '"'
                                   : std::string("was not there")) +
              ')';
    element->SetAttribute(parsed.GetAttribute().c_str(), value.c_str());
    setting.Elements.push_back(&entry);
  }
  if (mustBeRead) {
    m_store->AddSetting(std::move(setting));
  }
  return report;
}

void CConfigurationDocument::ForEachUnread(
    const std::function<void(const CConfigurationNode&, const std::string&)>& report) const {
  const std::function<void(tinyxml2::XMLElement&)> visit = [&](tinyxml2::XMLElement& element) {
    // a copy: the report may read the element
    const SConfigurationEntry entry = m_store->EntryOf(element);
    CConfigurationNode node;
    node.m_entry = &m_store->EntryOf(element);
    if (!entry.IsVisited) {
      report(node, "");
      return;
    }
    std::size_t index = 0;
    for (const auto* attribute = element.FirstAttribute(); attribute != nullptr;
         attribute = attribute->Next(), ++index) {
      if (!IsAttributeRead(entry, index)) {
        report(node, attribute->Name());
      }
    }
    for (auto* child = element.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      visit(*child);
    }
  };
  if (m_store->GetXml().RootElement() != nullptr) {
    visit(*m_store->GetXml().RootElement());
  }
}

std::vector<std::string> CConfigurationDocument::DescribeUnread() const {
  std::vector<std::string> lines;
  if (m_store->GetXml().RootElement() != nullptr) {
    m_store->DescribeUnread(*m_store->GetXml().RootElement(), lines);
  }
  return lines;
}

std::vector<std::string> CConfigurationDocument::DescribeRepeated() const {
  std::vector<std::string> lines;
  if (m_store->GetXml().RootElement() != nullptr) {
    m_store->DescribeRepeated(*m_store->GetXml().RootElement(), lines);
  }
  return lines;
}

std::vector<std::string> CConfigurationDocument::DescribeUnread(
    const CConfigurationNode& node) const {
  std::vector<std::string> lines;
  m_store->DescribeUnread(*node.Entry().Element, lines);
  return lines;
}

std::vector<std::string> CConfigurationDocument::DescribeUnreadSettings(
    const std::vector<const CConfigurationNode*>& pending) const {
  std::set<const tinyxml2::XMLNode*> elements;
  for (const CConfigurationNode* node : pending) {
    elements.insert(node->Entry().Element);
  }
  return m_store->DescribeUnreadSettings(elements);
}

}  // namespace argos
