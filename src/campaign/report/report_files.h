#ifndef ARGOS3_CAMPAIGN_REPORT_REPORT_FILES_H
#define ARGOS3_CAMPAIGN_REPORT_REPORT_FILES_H

// private: files of reports

#include <filesystem>
#include <string>

namespace argos {

/** Creates a folder with those above it. @throws CARGoSException if that fails. */
void CreateReportFolder(const std::filesystem::path& folder);

/** Writes or replaces a file. @throws CARGoSException if that fails. */
void WriteReportFile(const std::filesystem::path& path, const std::string& content);

}  // namespace argos

#endif
