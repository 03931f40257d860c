#include <argos3/core/utility/configuration/xml_text.h>

#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/core/utility/text/utf8.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <string_view>
#include <vector>

namespace argos {

namespace {

int LineOf(std::string_view xml, std::size_t at) {
  return 1 + static_cast<int>(std::count(xml.begin(), xml.begin() + at, '\n'));
}

// @return the offset after an end, from a start; the size of the text if there is no end
std::size_t Skip(std::string_view xml, std::size_t from, const char* end) {
  const std::size_t found = xml.find(end, from);
  return found == std::string_view::npos ? xml.size() : found + std::strlen(end);
}

bool StartsAt(std::string_view xml, std::size_t at, std::string_view start) {
  return xml.substr(at, start.size()) == start;
}

// @return the offset after the markup at a place whose contents are neither tags nor references; 0
// if there is none
std::size_t SkipOpaque(std::string_view xml, std::size_t at) {
  if (StartsAt(xml, at, "<!--")) {
    return Skip(xml, at, "-->");
  }
  if (StartsAt(xml, at, "<![CDATA[")) {
    return Skip(xml, at, "]]>");
  }
  if (StartsAt(xml, at, "<?")) {
    return Skip(xml, at, "?>");
  }
  return StartsAt(xml, at, "<!") ? Skip(xml, at, ">") : 0;
}

// @return where one of the characters is found that is not inside quotation marks; the size of the
// text if there is none
std::size_t FindUnquoted(std::string_view xml, std::size_t at, std::string_view characters) {
  for (char quote = '\0'; at < xml.size(); ++at) {
    if (quote != '\0') {
      quote = xml[at] == quote ? '\0' : quote;
    } else if (xml[at] == '"' || xml[at] == '\'') {
      quote = xml[at];
    } else if (characters.find(xml[at]) != std::string_view::npos) {
      return at;
    }
  }
  return at;
}

// references

// Source: XML 1.0, production 2
bool IsXmlCharacter(unsigned long code) {
  return code == 0x9 || code == 0xA || code == 0xD || (code >= 0x20 && code < 0xD800) ||
         (code >= 0xE000 && code < 0xFFFE) || (code >= 0x10000 && code < 0x110000);
}

// @param digits  between "&#" and ";"
bool IsCharacterNumber(std::string_view digits) {
  const int base = !digits.empty() && digits.front() == 'x' ? 16 : 10;
  digits.remove_prefix(base == 16 ? 1 : 0);
  unsigned long code = 0;
  const auto [end, error] = std::from_chars(digits.begin(), digits.end(), code, base);
  return error == std::errc() && end == digits.end() && IsXmlCharacter(code);
}

bool IsNameCharacter(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return std::isalnum(byte) != 0 || byte >= 0x80 || std::strchr("_:-.", c) != nullptr;
}

// @return what is wrong with the reference at '&'; empty if it is right
std::string DescribeReference(std::string_view xml, std::size_t at) {
  const std::string_view rest = xml.substr(at + 1);
  const bool isNumber = !rest.empty() && rest.front() == '#';
  std::size_t end = isNumber ? 1 : 0;
  while (end < rest.size() && IsNameCharacter(rest[end])) {
    ++end;
  }
  const std::string_view name = rest.substr(0, end);
  if (name.empty() || name == "#" || end == rest.size() || rest[end] != ';') {
    return "this \"&\" begins no entity and must be written \"&amp;\"";
  }
  if (isNumber) {
    return IsCharacterNumber(name.substr(1))
               ? ""
               : fmt::format("\"&{};\" is the number of no character that XML allows", name);
  }
  constexpr std::array<std::string_view, 5> kEntities = {"amp", "lt", "gt", "quot", "apos"};
  if (std::find(kEntities.begin(), kEntities.end(), name) != kEntities.end()) {
    return "";
  }
  return fmt::format(
      "there is no entity \"&{};\", only &amp; &lt; &gt; &quot; and &apos;; write its text, or "
      "\"&amp;{};\" if that is the text",
      name, name);
}

// @return true for "<!DOCTYPE ... ["
bool HasDeclarations(std::string_view xml, std::size_t at) {
  return StartsAt(xml, at, "<!DOCTYPE") && StartsAt(xml, FindUnquoted(xml, at, "[>"), "[");
}

// @return what is wrong with the character at a place; empty if nothing is
std::string DescribeFault(std::string_view xml, std::size_t at) {
  if (xml[at] == '&') {
    return DescribeReference(xml, at);
  }
  if (HasDeclarations(xml, at)) {
    return "declarations in a DOCTYPE, such as entities, are not supported: remove them, and write "
           "the texts of the entities where they are used";
  }
  if (CountUtf8Bytes(xml.substr(at)) > 0) {
    return "";
  }
  return fmt::format(
      "byte 0x{:02X} is not UTF-8; save the file as UTF-8, or name its encoding in the first line: "
      "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>",
      static_cast<unsigned char>(xml[at]));
}

// @return the next place from one on where a fault may be
std::size_t FindDoubtful(std::string_view xml, std::size_t at) {
  const auto* const found = std::find_if(xml.begin() + at, xml.end(), [](char c) {
    return c == '&' || c == '<' || static_cast<unsigned char>(c) >= 0x80;
  });
  return static_cast<std::size_t>(found - xml.begin());
}

// the declaration

/** A part of a text. */
struct SSpan {
  std::size_t Begin = 0;
  std::size_t Size = 0;
};

// the value of encoding="..." in the XML declaration; of size 0 if there is none
SSpan FindEncoding(std::string_view xml) {
  constexpr std::string_view kKey = "encoding";
  if (!StartsAt(xml, 0, "<?xml")) {
    return {};
  }
  const std::string_view declaration = xml.substr(0, Skip(xml, 0, "?>"));
  std::size_t at = declaration.find(kKey);
  if (at == std::string_view::npos) {
    return {};
  }
  at = declaration.find_first_of("\"'", at);
  const std::size_t end =
      at == std::string_view::npos ? at : declaration.find(declaration[at], at + 1);
  return end == std::string_view::npos ? SSpan() : SSpan{at + 1, end - at - 1};
}

std::string FromLatin1(std::string_view text) {
  std::string utf8;
  utf8.reserve(text.size());
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x80) {
      utf8 += c;
    } else {
      utf8 += static_cast<char>(0xC0 | (code >> 6));
      utf8 += static_cast<char>(0x80 | (code & 0x3F));
    }
  }
  return utf8;
}

// tags

struct STag {
  std::string Name;
  int Line = 0;
};

}  // namespace

SXmlFault FindXmlFault(const std::string& xml) {
  const std::string_view text = xml;
  const std::size_t zero = text.find('\0');
  if (zero != std::string_view::npos) {
    return {fmt::format("zero byte at offset {}; is it a text file, in UTF-8?", zero),
            LineOf(text, zero)};
  }
  for (std::size_t at = FindDoubtful(text, 0); at < text.size(); at = FindDoubtful(text, at)) {
    std::string fault = DescribeFault(text, at);
    if (!fault.empty()) {
      return {std::move(fault), LineOf(text, at)};
    }
    at = std::max(at + CountUtf8Bytes(text.substr(at)), SkipOpaque(text, at));
  }
  return {};
}

SXmlFault ConvertToUtf8(std::string& xml) {
  if (StartsAt(xml, 0, "\xFF\xFE") || StartsAt(xml, 0, "\xFE\xFF")) {
    return {"the file is encoded in UTF-16; save it as UTF-8", 1};
  }
  const SSpan span = FindEncoding(xml);
  const std::string name = xml.substr(span.Begin, span.Size);
  const std::string encoding = StringToLowerCase(name);
  if (encoding.empty() || encoding == "utf-8" || encoding == "utf8" || encoding == "us-ascii" ||
      encoding == "ascii") {
    return {};
  }
  if (encoding != "iso-8859-1" && encoding != "latin1" && encoding != "latin-1") {
    return {"the encoding \"" + name +
                "\" is not supported: save the file as UTF-8, or as ISO-8859-1, and name that in "
                "this line",
            LineOf(xml, span.Begin)};
  }
  xml = xml.substr(0, span.Begin) + "UTF-8" + FromLatin1(xml.substr(span.Begin + span.Size));
  return {};
}

SXmlFault FindMismatch(const std::string& xml) {
  std::vector<STag> open;
  int line = 1;
  std::size_t counted = 0;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at)) {
    const std::size_t opaque = SkipOpaque(xml, at);
    if (opaque > 0) {
      at = opaque;
      continue;
    }
    line += LineOf(std::string_view(xml).substr(counted), at - counted) - 1;
    counted = at;
    const bool closes = StartsAt(xml, at, "</");
    const std::size_t start = at + (closes ? 2 : 1);
    const std::string name = xml.substr(start, xml.find_first_of(" \t\r\n/>", start) - start);
    at = std::min(FindUnquoted(xml, at, ">") + 1, xml.size());
    if (!closes) {
      if (xml[at - 2] != '/') {
        open.push_back({name, line});
      }
    } else if (open.empty()) {
      return {"</" + name + "> closes an element that is not open", line};
    } else if (open.back().Name != name) {
      return {
          fmt::format("</{}> is found where </{}> must come first: <{}> of line {} is still open",
                      name, open.back().Name, open.back().Name, open.back().Line),
          line};
    } else {
      open.pop_back();
    }
  }
  if (open.empty()) {
    return {};
  }
  return {'<' + open.back().Name + "> is still open at the end of the file", open.back().Line};
}

}  // namespace argos
