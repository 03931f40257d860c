#include <argos3/plugins/simulator/visualizations/live/server/http_connection.h>

#include <argos3/plugins/simulator/visualizations/live/server/viewer_hub.h>

#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include <chrono>
#include <string_view>
#include <utility>

namespace argos {

namespace {

namespace beast = boost::beast;
namespace http = boost::beast::http;
using TError = boost::system::error_code;

constexpr std::chrono::seconds kTimeForRequest(5);
constexpr std::chrono::seconds kTimeForResponse(30);
constexpr UInt32 kMaxHeaderBytes = 8192;
constexpr UInt64 kMaxBodyBytes = 0;
constexpr size_t kMaxBufferBytes = 16384;

std::string ToString(beast::string_view text) {
  return std::string(text.data(), text.size());
}

// no page of another site may show this one in a frame, and this one loads nothing
std::string MakeContentPolicy(const std::string& host) {
  return "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval'; style-src "
         "'unsafe-inline'; img-src data: "
         "blob:; font-src data:; worker-src blob:; connect-src 'self' data: ws://" +
         host + " wss://" + host + "; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
}

// the page itself reads what follows "?"
bool IsPage(std::string_view target) {
  return target == "/" || target == "/index.html" || target == "/?detail=full" ||
         target == "/?detail=low";
}

}  // namespace

CHTTPConnection::CHTTPConnection(beast::tcp_stream&& stream, CViewerHub& hub, const SLivePage& page,
                                 size_t& count)
    : m_stream(std::move(stream)),
      m_hub(hub),
      m_page(page),
      m_count(count),
      m_buffer(kMaxBufferBytes) {
  ++m_count;
}

CHTTPConnection::~CHTTPConnection() {
  --m_count;
}

void CHTTPConnection::Read() {
  m_parser.emplace();
  m_parser->header_limit(kMaxHeaderBytes);
  m_parser->body_limit(kMaxBodyBytes);
  m_stream.expires_after(kTimeForRequest);
  http::async_read(m_stream, m_buffer, *m_parser,
                   [self = shared_from_this()](TError error, size_t) {
                     if (!error) {
                       self->OnRequest();
                     }
                   });
}

void CHTTPConnection::OnRequest() {
  const TLiveRequest request = m_parser->release();
  const std::string target = ToString(request.target());
  const bool isHead = request.method() == http::verb::head;
  m_response.keep_alive(false);
  if (!IsAllowedHost(ToString(request[http::field::host]), m_hub.GetAccess())) {
    Respond(http::status::forbidden, "This live view has another address.\n", "text/plain");
  } else if (target == "/live") {
    const std::string problem = FindProblemOfViewer(request);
    if (problem.empty()) {
      std::make_shared<CViewerConnection>(std::move(m_stream), m_hub)->Accept(request);
    } else {
      Respond(http::status::forbidden, problem + '\n', "text/plain");
    }
  } else if (!isHead && request.method() != http::verb::get) {
    Respond(http::status::method_not_allowed, "GET only.\n", "text/plain");
  } else if (!IsPage(target)) {
    Respond(http::status::not_found, "There is only one page: /\n", "text/plain");
  } else {
    RespondWithPage(request);
  }
}

void CHTTPConnection::RespondWithPage(const TLiveRequest& request) {
  m_response.set("Content-Security-Policy",
                 MakeContentPolicy(ToString(request[http::field::host])));
  m_response.set(http::field::vary, "Accept-Encoding");
  const bool isPacked =
      !m_page.Packed.empty() && AcceptsGzip(ToString(request[http::field::accept_encoding]));
  if (isPacked) {
    m_response.set(http::field::content_encoding, "gzip");
  }
  const std::string& body = isPacked ? m_page.Packed : m_page.Text;
  Respond(http::status::ok, request.method() == http::verb::head ? "" : body,
          "text/html; charset=utf-8");
}

// @return why the request cannot become a viewer; empty if it can
std::string CHTTPConnection::FindProblemOfViewer(const TLiveRequest& request) const {
  if (!beast::websocket::is_upgrade(request)) {
    return "This is the address of a WebSocket.";
  }
  if (!IsAllowedOrigin(ToString(request[http::field::origin]),
                       ToString(request[http::field::host]))) {
    return "Pages of other sites may not connect.";
  }
  if (request[http::field::sec_websocket_protocol] != kLiveProtocol) {
    return std::string("The protocol is ") + kLiveProtocol + '.';
  }
  if (m_hub.CountConnections() >= kMaxConnections) {
    return "There are too many connections.";
  }
  return "";
}

void CHTTPConnection::Respond(http::status status, std::string text, const char* type) {
  m_response.result(status);
  m_response.set(http::field::content_type, type);
  m_response.set(http::field::cache_control, "no-store");
  m_response.set("X-Content-Type-Options", "nosniff");
  m_response.set("Referrer-Policy", "no-referrer");
  m_response.set("Cross-Origin-Opener-Policy", "same-origin");
  m_response.body() = std::move(text);
  m_response.prepare_payload();
  m_stream.expires_after(kTimeForResponse);
  http::async_write(m_stream, m_response, [self = shared_from_this()](TError, size_t) {
    TError ignored;
    self->m_stream.socket().shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
  });
}

}  // namespace argos
