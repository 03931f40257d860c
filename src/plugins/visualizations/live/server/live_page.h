#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_SERVER_LIVE_PAGE_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_SERVER_LIVE_PAGE_H

#include <string>

namespace argos {

/** The page of the live view. */
struct SLivePage {
  std::string Text; /**< HTML */
  std::string Packed; /**< the same, compressed by gzip; empty: only the text is there */
};

}  // namespace argos

#endif
