#include "xml_tree.h"

namespace argos {

namespace {

class CParser {
 public:
  explicit CParser(const std::string& text) : m_text(text) {}

  std::unique_ptr<SXmlElement> Parse() {
    m_at = m_text.find('<');
    while (m_text.compare(m_at, 2, "<?") == 0 || m_text.compare(m_at, 4, "<!--") == 0) {
      SkipMarkup();
      m_at = m_text.find('<', m_at);
    }
    return ParseElement();
  }

 private:
  void SkipMarkup() {
    const char* const end = m_text.compare(m_at, 4, "<!--") == 0 ? "-->" : ">";
    m_at = m_text.find(end, m_at) + std::string(end).size();
  }

  std::string TakeUntil(const char* characters) {
    const std::size_t begin = m_at;
    m_at = m_text.find_first_of(characters, m_at);
    return m_text.substr(begin, m_at - begin);
  }

  // at '<'
  std::unique_ptr<SXmlElement> ParseElement() {
    auto element = std::make_unique<SXmlElement>();
    ++m_at;
    element->Tag = TakeUntil(" \t\r\n/>");
    for (;;) {
      m_at = m_text.find_first_not_of(" \t\r\n", m_at);
      if (m_text[m_at] == '/') {
        m_at += 2;
        return element;
      }
      if (m_text[m_at] == '>') {
        ++m_at;
        break;
      }
      const std::string name = TakeUntil(" \t\r\n=");
      m_at = m_text.find_first_of("\"'", m_at);
      const char quote[] = {m_text[m_at++], '\0'};
      element->Attributes.emplace_back(name, TakeUntil(quote));
      ++m_at;
    }
    ParseContents(*element);
    return element;
  }

  void ParseContents(SXmlElement& element) {
    for (;;) {
      element.Text += TakeUntil("<");
      if (m_text[m_at + 1] == '!') {
        SkipMarkup();
      } else if (m_text[m_at + 1] == '/') {
        m_at = m_text.find('>', m_at) + 1;
        return;
      } else {
        element.Children.push_back(ParseElement());
      }
    }
  }

  const std::string& m_text;
  std::size_t m_at = 0;
};

void Append(const SXmlElement& element, std::string& text) {
  text += '<' + element.Tag;
  for (const auto& [name, value] : element.Attributes) {
    text += ' ' + name + "=\"" + value + '"';
  }
  text += '>';
  const std::size_t first = element.Text.find_first_not_of(" \t\r\n");
  if (first != std::string::npos) {
    text += element.Text.substr(first);
  }
  text += '\n';
  for (const auto& child : element.Children) {
    Append(*child, text);
  }
  text += "</" + element.Tag + ">\n";
}

void List(SXmlElement& element, std::vector<SXmlPlace>& places) {
  for (std::size_t i = 0; i < element.Children.size(); ++i) {
    places.push_back({element.Children[i].get(), &element.Children, i});
    List(*element.Children[i], places);
  }
}

}  // namespace

std::unique_ptr<SXmlElement> SXmlElement::Clone() const {
  auto copy = std::make_unique<SXmlElement>();
  copy->Tag = Tag;
  copy->Attributes = Attributes;
  copy->Text = Text;
  for (const auto& child : Children) {
    copy->Children.push_back(child->Clone());
  }
  return copy;
}

std::unique_ptr<SXmlElement> ParseXml(const std::string& text) {
  return CParser(text).Parse();
}

std::string ToText(const SXmlElement& element) {
  std::string text;
  Append(element, text);
  return text;
}

std::vector<SXmlPlace> ListElements(SXmlElement& root) {
  std::vector<SXmlPlace> places = {{&root, nullptr, 0}};
  List(root, places);
  return places;
}

}  // namespace argos
