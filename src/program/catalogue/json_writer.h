#ifndef ARGOS3_PROGRAM_CATALOGUE_JSON_WRITER_H
#define ARGOS3_PROGRAM_CATALOGUE_JSON_WRITER_H

#include <string>

namespace argos {

/** Writes JSON (RFC 8259) with a line for each value. */
class CJsonWriter {
 public:
  /** @param key  "" inside an array, and for the outermost value. */
  void BeginObject(const std::string& key = "") { Begin(key, '{'); }
  void EndObject() { End('}'); }
  void BeginArray(const std::string& key) { Begin(key, '['); }
  void EndArray() { End(']'); }
  void Add(const std::string& key, const std::string& text);
  void Add(const std::string& key, const char* text) { Add(key, std::string(text)); }
  void Add(const std::string& key, bool value);

  const std::string& GetText() const { return m_text; }

 private:
  void Begin(const std::string& key, char bracket);
  void End(char bracket);
  void StartValue(const std::string& key);

  std::string m_text;
  std::size_t m_depth = 0;
  bool m_isFirst = true;
};

/** The text in quotation marks, with escapes; bytes that are no UTF-8 become U+FFFD. */
std::string JsonQuoted(const std::string& text);

}  // namespace argos

#endif
