#include <argos3/plugins/simulator/visualizations/live/server/live_server.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/plugins/simulator/visualizations/live/server/http_connection.h>
#include <argos3/plugins/simulator/visualizations/live/server/viewer_hub.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

#include <pthread.h>

#include <csignal>
#include <thread>
#include <utility>

namespace argos {

namespace {

namespace asio = boost::asio;
using tcp = boost::asio::ip::tcp;
using TError = boost::system::error_code;

constexpr std::chrono::seconds kStatusPeriod(1);
constexpr std::chrono::seconds kLongestStop(1);
// after a failed accept(), such as without free file descriptors
constexpr std::chrono::milliseconds kPauseAfterError(200);

}  // namespace

class CLiveServer::CImpl {
 public:
  CImpl(SLiveServerSettings settings, CLiveLink& link)
      : m_settings(std::move(settings)),
        m_link(link),
        m_hub(m_settings.Access, m_settings.StatesPerSecond, link) {
    Listen();
    m_hub.SetHasControl(m_settings.HasControl);
    m_hub.SetReadyHandler([this] { WaitForRates(); });
  }

  ~CImpl() { Stop(""); }
  CImpl(const CImpl&) = delete;
  CImpl& operator=(const CImpl&) = delete;

  UInt16 GetPort() const { return m_acceptor.local_endpoint().port(); }
  const SLiveAccess& GetAccess() const { return m_settings.Access; }

  void Start(const std::string& info, const TJson& welcome) {
    CBlockPacker packer(1);
    SBlockHeader header;
    header.Kind = EBlock::Info;
    m_hub.SetShow({std::string(packer.Pack(header, info)), welcome});
    m_link.SetNotifier([this] { asio::post(m_context, [this] { m_hub.OnRun(); }); });
    AcceptNext();
    SendStatusLater();
    StartThread();
  }

  void Stop(const std::string& reason) {
    if (!m_thread.joinable()) {
      return;
    }
    m_link.SetNotifier({});
    asio::post(m_context, [this, reason] {
      m_hub.OnRun();
      m_hub.CloseAll(reason);
      m_acceptor.close();
      m_statusTimer.cancel();
      m_dueTimer.cancel();
      // connections that remain keep the context busy
      m_stopTimer.expires_after(kLongestStop);
      m_stopTimer.async_wait([this](TError) { m_context.stop(); });
      StopWhenAlone();
    });
    m_thread.join();
  }

 private:
  void Listen() {
    TError error;
    const asio::ip::address address = asio::ip::make_address(m_settings.Access.Address, error);
    const auto check = [&](const char* what) {
      if (error) {
        THROW_ARGOSEXCEPTION("the live view cannot " << what << ' ' << m_settings.Access.Address
                                                     << ", port " << m_settings.Port << ": "
                                                     << error.message());
      }
    };
    check("use the address");
    const tcp::endpoint endpoint(address, m_settings.Port);
    m_acceptor.open(endpoint.protocol(), error);
    check("use the address");
    m_acceptor.set_option(asio::socket_base::reuse_address(true), error);
    m_acceptor.bind(endpoint, error);
    check("listen on");
    m_acceptor.listen(asio::socket_base::max_listen_connections, error);
    check("listen on");
  }

  // signals are for the main thread
  void StartThread() {
    sigset_t all;
    sigset_t before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    m_thread = std::thread([this] { m_context.run(); });
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }

  void AcceptNext() {
    m_acceptor.async_accept([this](TError error, tcp::socket socket) {
      if (error == asio::error::operation_aborted) {
        return;
      }
      if (error) {
        m_acceptTimer.expires_after(kPauseAfterError);
        m_acceptTimer.async_wait([this](TError aborted) {
          if (!aborted && m_acceptor.is_open()) {
            AcceptNext();
          }
        });
        return;
      }
      if (m_numConnections < CHTTPConnection::kMaxConnections) {
        TError ignored;
        socket.set_option(tcp::no_delay(true), ignored);
        std::make_shared<CHTTPConnection>(boost::beast::tcp_stream(std::move(socket)), m_hub,
                                          m_settings.Page, m_numConnections)
            ->Read();
      }
      AcceptNext();
    });
  }

  // the rates of viewers are checked when one may be due
  void WaitForRates() {
    const auto next = m_hub.GetNextDueTime();
    if (!next || !m_acceptor.is_open()) {
      return;
    }
    m_dueTimer.expires_at(*next);
    m_dueTimer.async_wait([this](TError error) {
      if (!error) {
        m_hub.OnReady();
      }
    });
  }

  void SendStatusLater() {
    m_statusTimer.expires_after(kStatusPeriod);
    m_statusTimer.async_wait([this](TError error) {
      if (!error) {
        m_hub.SendStatus();
        SendStatusLater();
      }
    });
  }

  void StopWhenAlone() {
    m_acceptTimer.expires_after(std::chrono::milliseconds(10));
    m_acceptTimer.async_wait([this](TError error) {
      if (!error) {
        if (m_hub.CountConnections() > 0) {
          StopWhenAlone();
        } else {
          m_context.stop();
        }
      }
    });
  }

  SLiveServerSettings m_settings;
  CLiveLink& m_link;
  size_t m_numConnections = 0;  // counted by these, which the context owns
  asio::io_context m_context{1};
  CViewerHub m_hub;
  tcp::acceptor m_acceptor{m_context};
  asio::steady_timer m_acceptTimer{m_context};
  asio::steady_timer m_statusTimer{m_context};
  asio::steady_timer m_dueTimer{m_context};
  asio::steady_timer m_stopTimer{m_context};
  std::thread m_thread;
};

CLiveServer::CLiveServer(SLiveServerSettings settings, CLiveLink& link)
    : m_impl(std::make_unique<CImpl>(std::move(settings), link)) {}

CLiveServer::~CLiveServer() = default;

UInt16 CLiveServer::GetPort() const {
  return m_impl->GetPort();
}

std::string CLiveServer::GetURL() const {
  const SLiveAccess& access = m_impl->GetAccess();
  std::string host = access.Address;
  if (host == "0.0.0.0" || host == "::") {
    host = "localhost";
  } else if (host.find(':') != std::string::npos) {
    host = '[' + host + ']';
  }
  return "http://" + host + ':' + std::to_string(GetPort()) + "/#" + access.Token;
}

void CLiveServer::Start(const std::string& info, const TJson& welcome) {
  m_impl->Start(info, welcome);
}

void CLiveServer::Stop(const std::string& reason) {
  m_impl->Stop(reason);
}

}  // namespace argos
