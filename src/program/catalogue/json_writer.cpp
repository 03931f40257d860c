#include <argos3/program/catalogue/json_writer.h>

#include <argos3/core/utility/text/utf8.h>

#include <fmt/format.h>

#include <string_view>

namespace argos {

std::string JsonQuoted(const std::string& text) {
  std::string quoted = "\"";
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t size = CountUtf8Bytes(std::string_view(text).substr(at));
    const char c = text[at];
    if (size == 0) {
      quoted += "\\ufffd";
    } else if (size > 1) {
      quoted += text.substr(at, size);
    } else if (c == '"' || c == '\\') {
      quoted += std::string("\\") + c;
    } else if (c == '\n') {
      quoted += "\\n";
    } else if (static_cast<unsigned char>(c) < 0x20) {
      quoted += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      quoted += c;
    }
    at += size == 0 ? 1 : size;
  }
  return quoted + '"';
}

void CJsonWriter::StartValue(const std::string& key) {
  if (m_depth > 0) {
    m_text += (m_isFirst ? "\n" : ",\n") + std::string(2 * m_depth, ' ');
  }
  m_isFirst = false;
  if (!key.empty()) {
    m_text += JsonQuoted(key) + ": ";
  }
}

void CJsonWriter::Begin(const std::string& key, char bracket) {
  StartValue(key);
  m_text += bracket;
  ++m_depth;
  m_isFirst = true;
}

void CJsonWriter::End(char bracket) {
  --m_depth;
  if (!m_isFirst) {
    m_text += '\n' + std::string(2 * m_depth, ' ');
  }
  m_text += bracket;
  m_isFirst = false;
  if (m_depth == 0) {
    m_text += '\n';
  }
}

void CJsonWriter::Add(const std::string& key, const std::string& text) {
  StartValue(key);
  m_text += JsonQuoted(text);
}

void CJsonWriter::Add(const std::string& key, bool value) {
  StartValue(key);
  m_text += value ? "true" : "false";
}

}  // namespace argos
