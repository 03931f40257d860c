#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_SERVER_HTTP_CONNECTION_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_SERVER_HTTP_CONNECTION_H

#include <argos3/plugins/simulator/visualizations/live/server/live_page.h>
#include <argos3/plugins/simulator/visualizations/live/server/viewer_connection.h>

#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>

#include <atomic>
#include <memory>
#include <optional>
#include <string>

namespace argos {

class CViewerHub;

/** A connection with one request: for the page, or to become that of a viewer. */
class CHTTPConnection : public std::enable_shared_from_this<CHTTPConnection> {
 public:
  /** Connections at a time; of viewers, too. */
  static constexpr size_t kMaxConnections = 256;

  /** @param count  of connections, which this one is added to. */
  CHTTPConnection(boost::beast::tcp_stream&& stream, CViewerHub& hub, const SLivePage& page,
                  size_t& count);
  ~CHTTPConnection();
  CHTTPConnection(const CHTTPConnection&) = delete;
  CHTTPConnection& operator=(const CHTTPConnection&) = delete;

  void Read();

 private:
  using TResponse = boost::beast::http::response<boost::beast::http::string_body>;

  void OnRequest();
  std::string FindProblemOfViewer(const TLiveRequest& request) const;
  void RespondWithPage(const TLiveRequest& request);
  void Respond(boost::beast::http::status status, std::string text, const char* type);

  boost::beast::tcp_stream m_stream;
  CViewerHub& m_hub;
  const SLivePage& m_page;
  size_t& m_count;
  boost::beast::flat_buffer m_buffer;
  std::optional<boost::beast::http::request_parser<boost::beast::http::string_body>> m_parser;
  TResponse m_response;
};

}  // namespace argos

#endif
