#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_PAGE_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_PAGE_H

#include <string>

namespace argos {

/**
 * The page of the live view, as HTML; if it was not built, one that says so.
 * @param prefix  of the installation, or the folder of the build.
 */
std::string ReadPage(const std::string& prefix);

}  // namespace argos

#endif
