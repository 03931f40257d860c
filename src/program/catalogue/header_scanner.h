#ifndef ARGOS3_PROGRAM_CATALOGUE_HEADER_SCANNER_H
#define ARGOS3_PROGRAM_CATALOGUE_HEADER_SCANNER_H

#include <string>

namespace argos {

/**
 * Reads the declarations of a class or of a file one by one. It knows comments, strings and nested
 * brackets, and no more of C++.
 */
class CHeaderScanner {
 public:
  /** @param text  must exist as long as the scanner. */
  explicit CHeaderScanner(const std::string& text) : m_text(text) {}

  /** @return false at the end. */
  bool Next();

  /** "public", "protected" or "private" if the last item was such a label. */
  const std::string& GetLabel() const { return m_label; }
  /** The declaration before its body, its initialiser or the semicolon, on one line. */
  const std::string& GetCode() const { return m_code; }
  /** What is between the braces of the body; "" if there is none. */
  const std::string& GetBody() const { return m_body; }
  /** The comment before or behind it, as text. */
  const std::string& GetComment() const { return m_comment; }

 private:
  void SkipBlanks();
  bool SkipComment();
  void SkipLine();
  void ReadDeclaration();
  void ReadCommentBehind();
  bool StartsWith(const char* word) const;
  std::size_t EndOfBrackets(std::size_t begin) const;

  const std::string& m_text;
  std::size_t m_at = 0;
  std::string m_label;
  std::string m_code;
  std::string m_body;
  std::string m_comment;
};

/** The text of a comment: without asterisks, tags such as @param in words. */
std::string PlainComment(const std::string& comment);

}  // namespace argos

#endif
