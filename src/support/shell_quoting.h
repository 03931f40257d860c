#ifndef ARGOS3_SUPPORT_SHELL_QUOTING_H
#define ARGOS3_SUPPORT_SHELL_QUOTING_H

#include <string>

namespace argos {

/** @return a word of a command line, in single quotes if a shell would change it otherwise. */
std::string QuoteForShell(const std::string& word);

}  // namespace argos

#endif
