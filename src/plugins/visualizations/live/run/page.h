#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_PAGE_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_PAGE_H

#include <argos3/plugins/simulator/visualizations/live/server/live_page.h>

#include <string>

namespace argos {

/**
 * The page of the live view; if it was not built, one that says so.
 * @param prefix  of the installation, or the folder of the build.
 */
SLivePage ReadPage(const std::string& prefix);

}  // namespace argos

#endif
