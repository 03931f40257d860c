#ifndef ARGOS3_PROGRAM_PAGE_EXPORT_H
#define ARGOS3_PROGRAM_PAGE_EXPORT_H

#include <string>

namespace argos {

/**
 * Writes the page of the live view with a recording inside, as one HTML file that needs no server.
 * @param prefix  of the installation, which has the page.
 * @throws CARGoSException if the recording cannot be read or is none, if the page was not built, if
 *   the file cannot be written; an older file then stays.
 */
void ExportPage(const std::string& recording, const std::string& file, const std::string& prefix);

}  // namespace argos

#endif
