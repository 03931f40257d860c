#include <argos3/program/catalogue/schema_pattern.h>

#include <argos3/core/utility/text/string_utilities.h>

#include <fmt/format.h>

namespace argos {

namespace {

using EKind = SSchemaPattern::EKind;

constexpr const char* kOrigin =
    "Made by argos3 from what the plug-ins read: the option \"schema\". Do not edit.";

std::string Escaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    escaped += c == '<'   ? "&lt;"
               : c == '>' ? "&gt;"
               : c == '&' ? "&amp;"
               : c == '"' ? "&quot;"
                          : std::string(1, c);
  }
  return escaped;
}

/* Writes one element of XML for each pattern. */
class CXmlWriter {
 public:
  void Write(const SSchemaPattern& pattern, size_t depth) {
    switch (pattern.Kind) {
      case EKind::Element:
        WriteNamed("element", pattern, depth);
        break;
      case EKind::Attribute:
        WriteNamed("attribute", pattern, depth);
        break;
      case EKind::Optional:
        WriteParts("optional", pattern, depth);
        break;
      case EKind::ZeroOrMore:
        WriteParts("zeroOrMore", pattern, depth);
        break;
      case EKind::Choice:
        WriteParts("choice", pattern, depth);
        break;
      case EKind::Group:
        WriteParts("group", pattern, depth);
        break;
      case EKind::Value:
        Line(depth, "<value>" + Escaped(pattern.Name) + "</value>");
        break;
      case EKind::Reference:
        Line(depth, "<ref name=\"" + Escaped(pattern.Name) + "\"/>");
        break;
      case EKind::Matching:
        Line(depth, "<data type=\"string\"><param name=\"pattern\">" + Escaped(pattern.Name) +
                        "</param></data>");
        break;
      case EKind::Text:
        Line(depth, "<text/>");
        break;
      case EKind::Empty:
        Line(depth, "<empty/>");
        break;
    }
  }

  void Line(size_t depth, const std::string& text) {
    m_text += std::string(2 * depth, ' ') + text + '\n';
  }

  const std::string& GetText() const { return m_text; }

 private:
  void WriteParts(const std::string& tag, const SSchemaPattern& pattern, size_t depth) {
    Line(depth, '<' + tag + '>');
    for (const SSchemaPattern& part : pattern.Parts) {
      Write(part, depth + 1);
    }
    Line(depth, "</" + tag + '>');
  }

  void WriteNamed(const std::string& tag, const SSchemaPattern& pattern, size_t depth) {
    Line(depth,
         '<' + tag + (pattern.Name.empty() ? "" : " name=\"" + Escaped(pattern.Name) + '"') + '>');
    if (pattern.Name.empty()) {
      std::string names;
      for (const std::string& name : pattern.Except) {
        names += "<name>" + Escaped(name) + "</name>";
      }
      Line(depth + 1,
           names.empty() ? "<anyName/>" : "<anyName><except>" + names + "</except></anyName>");
    }
    if (!pattern.Text.empty()) {
      Line(depth + 1, "<a:documentation>" + Escaped(pattern.Text) + "</a:documentation>");
    }
    for (const SSchemaPattern& part : pattern.Parts) {
      Write(part, depth + 1);
    }
    if (pattern.Parts.empty()) {
      Line(depth + 1, pattern.Kind == EKind::Attribute ? "<text/>" : "<empty/>");
    }
    Line(depth, "</" + tag + '>');
  }

  std::string m_text;
};

/* Writes the compact syntax. Parts are joined by commas, those of a choice by bars. */
class CCompactWriter {
 public:
  static std::string Write(const SSchemaPattern& pattern, size_t depth) {
    switch (pattern.Kind) {
      case EKind::Element:
        return WriteNamed("element", pattern, depth);
      case EKind::Attribute:
        return WriteNamed("attribute", pattern, depth);
      case EKind::Optional:
        return fmt::format("({})?", Join(pattern, ",", depth));
      case EKind::ZeroOrMore:
        return fmt::format("({})*", Join(pattern, ",", depth));
      case EKind::Choice:
        return fmt::format("({})", Join(pattern, " |", depth));
      case EKind::Group:
        return fmt::format("({})", Join(pattern, ",", depth));
      case EKind::Value:
        return Quoted(pattern.Name);
      case EKind::Reference:
        return pattern.Name;
      case EKind::Matching:
        return "xsd:string { pattern = " + Quoted(pattern.Name) + " }";
      case EKind::Text:
        return "text";
      default:
        return "empty";
    }
  }

 private:
  static std::string Quoted(const std::string& text) {
    // no escapes inside quotation marks; three of them allow one inside
    const char* const quote = text.find('"') == std::string::npos ? "\"" : "\"\"\"";
    return fmt::format("{0}{1}{0}", quote, text);
  }

  static std::string Join(const SSchemaPattern& pattern, const std::string& sign, size_t depth) {
    if (pattern.Parts.empty()) {
      return "empty";
    }
    std::string text;
    for (const SSchemaPattern& part : pattern.Parts) {
      text += text.empty() ? std::string() : fmt::format("{}\n{:{}}", sign, "", 2 * depth);
      text += Write(part, depth);
    }
    return text;
  }

  static std::string Documentation(const std::string& text, size_t depth) {
    const std::string indent(2 * depth, ' ');
    std::string lines = "## " + text;
    Replace(lines, "\n", fmt::format("\n{}## ", indent));
    return lines + '\n' + indent;
  }

  // names that are words of the syntax need no backslash here: they follow "element" or "attribute"
  static std::string NameOf(const SSchemaPattern& pattern) {
    if (!pattern.Name.empty()) {
      return pattern.Name;
    }
    std::string names;
    for (const std::string& name : pattern.Except) {
      names += (names.empty() ? "" : " | ") + name;
    }
    return names.empty() ? "*" : "* - (" + names + ")";
  }

  static std::string WriteNamed(const std::string& word, const SSchemaPattern& pattern,
                                size_t depth) {
    const std::string empty = pattern.Kind == EKind::Attribute ? "text" : "empty";
    const std::string parts = pattern.Parts.empty() ? empty : Join(pattern, ",", depth + 1);
    return (pattern.Text.empty() ? "" : Documentation(pattern.Text, depth)) + word + ' ' +
           NameOf(pattern) + " { " + parts + " }";
  }
};

}  // namespace

std::string WriteRelaxNg(const SSchema& schema) {
  CXmlWriter writer;
  writer.Line(0, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>");
  writer.Line(0, std::string("<!-- ") + kOrigin + " -->");
  writer.Line(0,
              "<grammar xmlns=\"http://relaxng.org/ns/structure/1.0\"\n"
              "  xmlns:a=\"http://relaxng.org/ns/compatibility/annotations/1.0\"\n"
              "  datatypeLibrary=\"http://www.w3.org/2001/XMLSchema-datatypes\">");
  for (const auto& [name, pattern] : schema.Definitions) {
    const bool isStart = name == "start";
    writer.Line(1, isStart ? "<start>" : "<define name=\"" + Escaped(name) + "\">");
    writer.Write(pattern, 2);
    writer.Line(1, isStart ? "</start>" : "</define>");
  }
  writer.Line(0, "</grammar>");
  return writer.GetText();
}

std::string WriteRelaxNgCompact(const SSchema& schema) {
  std::string text = std::string("# ") + kOrigin + "\n";
  for (const auto& [name, pattern] : schema.Definitions) {
    text += name + " =\n  " + CCompactWriter::Write(pattern, 1) + "\n";
  }
  return text;
}

}  // namespace argos
