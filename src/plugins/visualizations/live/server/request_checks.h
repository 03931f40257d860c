#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_SERVER_REQUEST_CHECKS_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_SERVER_REQUEST_CHECKS_H

#include <string>
#include <string_view>
#include <vector>

namespace argos {

/** Who may view a run. */
struct SLiveAccess {
  std::string Address; /**< on which the server listens */
  std::vector<std::string> Hosts; /**< other names by which it may be called */
  std::string Token; /**< of the URL */
};

/** 128 random bits, as 32 hexadecimal digits. @throws CARGoSException */
std::string MakeLiveToken();
/** Takes the same time for all texts of one length. */
bool IsSameToken(std::string_view given, std::string_view expected);

/**
 * Whether a request may have this header "Host". A page of another site whose name leads to this
 * computer, by a name server that its author controls, has the name of that site. The port is not
 * compared: a tunnel may have another one.
 */
bool IsAllowedHost(std::string_view host, const SLiveAccess& access);
/**
 * Whether a page of this origin may connect: that of @p host, by http or https. Programs that are
 * no browsers send no origin; they need the token, as all do.
 */
bool IsAllowedOrigin(std::string_view origin, std::string_view host);

/** Whether a request with this header "Accept-Encoding" may be answered with what gzip has packed.
 */
bool AcceptsGzip(std::string_view encodings);

}  // namespace argos

#endif
