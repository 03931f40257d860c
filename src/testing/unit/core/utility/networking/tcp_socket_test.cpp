#include <argos3/core/utility/networking/tcp_socket.h>

#include <argos3/core/utility/configuration/argos_exception.h>

#include <catch2/catch.hpp>

#include <thread>
#include <utility>

namespace tcp_socket_test {

using namespace argos;
using Catch::Contains;

namespace {

// both ends of a connection on this machine
struct SConnection {
  SConnection() {
    CTCPSocket listener;
    listener.Listen(0);
    Client.Connect("127.0.0.1", listener.GetPort());
    listener.Accept(Server);
  }
  CTCPSocket Client;
  CTCPSocket Server;
};

}  // namespace

TEST_CASE("socket: both ends report that they are connected", "[core][network]") {
  CTCPSocket closed;
  CHECK_FALSE(closed.IsConnected());
  CHECK(closed.GetStream() == -1);
  CHECK(closed.GetAddress().empty());
  SConnection connection;
  CHECK(connection.Client.IsConnected());
  CHECK(connection.Server.IsConnected());
  CHECK(connection.Client.GetAddress() == "127.0.0.1");
  CHECK(connection.Server.GetAddress() == "127.0.0.1");
  CHECK(connection.Client.GetStream() >= 0);
  connection.Client.Disconnect();
  CHECK_FALSE(connection.Client.IsConnected());
}

TEST_CASE("socket: bytes, byte arrays and messages arrive as sent", "[core][network]") {
  SConnection connection;
  const UInt8 sent[] = {1, 2, 3};
  connection.Client.SendBuffer(sent, 3);
  UInt8 received[3] = {};
  connection.Server.ReceiveBuffer(received, 3);
  CHECK(received[0] == 1);
  CHECK(received[2] == 3);

  CByteArray array;
  array << UInt32(7) << std::string("text");
  connection.Server.SendByteArray(array);
  CByteArray back(3, 9);
  connection.Client.ReceiveByteArray(back);
  CHECK(back == array);

  connection.Client.SendMsg("hello\nworld");
  connection.Client.SendMsg("");
  std::string message;
  connection.Server.RecvMsg(message);
  CHECK(message == "hello\nworld");
  connection.Server.RecvMsg(message);
  CHECK(message.empty());
}

TEST_CASE("socket: a byte array is sent as its length and its bytes", "[core][network]") {
  SConnection connection;
  connection.Client.SendByteArray(CByteArray(2, 5));
  UInt8 received[6] = {};
  connection.Server.ReceiveBuffer(received, 6);
  CHECK(std::vector<int>(received, received + 6) == std::vector<int>{0, 0, 0, 2, 5, 5});
}

TEST_CASE("socket: data much larger than a packet arrives", "[core][network]") {
  SConnection connection;
  CByteArray array(3000000, 1);
  array[2999999] = 2;
  std::thread sender([&connection, &array] { connection.Client.SendByteArray(array); });
  CByteArray back;
  connection.Server.ReceiveByteArray(back);
  sender.join();
  CHECK(back == array);
}

TEST_CASE("socket: events list the operations that do not block", "[core][network]") {
  SConnection connection;
  typedef CTCPSocket::EEvent EEvent;
  CHECK(connection.Server.GetEvents().count(EEvent::InputReady) == 0);
  CHECK(connection.Server.GetEvents().count(EEvent::OutputReady) == 1);
  connection.Client.SendMsg("x");
  std::string message;
  connection.Server.RecvMsg(message);
  connection.Client.Disconnect();
  // the end of a connection counts as input; it arrives fast, but not immediately
  for (int i = 0; i < 1000 && connection.Server.GetEvents().count(EEvent::InputReady) == 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  CHECK(connection.Server.GetEvents().count(EEvent::InputReady) == 1);
  CHECK(CTCPSocket().GetEvents() == std::set<EEvent>{EEvent::InvalidRequest});
}

TEST_CASE("socket: moving transfers the connection", "[core][network]") {
  SConnection connection;
  CTCPSocket moved(std::move(connection.Client));
  CHECK(moved.IsConnected());
  CTCPSocket assigned;
  assigned = std::move(moved);
  assigned.SendMsg("moved");
  std::string message;
  connection.Server.RecvMsg(message);
  CHECK(message == "moved");
}

TEST_CASE("socket: a length of the peer beyond the limit allocates nothing", "[core][network]") {
  SConnection connection;
  CHECK(connection.Server.GetMaxMessageSize() == 64 * 1024 * 1024);
  const UInt8 huge[] = {0xFF, 0xFF, 0xFF, 0xFF, 'G', 'E', 'T'};
  connection.Client.SendBuffer(huge, sizeof huge);
  CByteArray received;
  CHECK_THROWS_WITH(connection.Server.ReceiveByteArray(received),
                    Contains("cannot receive a message of 4294967295 bytes, expected at most "
                             "67108864"));
  CHECK_FALSE(connection.Server.IsConnected());
  CHECK(received.Empty());
}

TEST_CASE("socket: the limit of a message can be set, for both directions", "[core][network]") {
  SConnection connection;
  connection.Client.SetMaxMessageSize(3);
  CHECK_THROWS_WITH(connection.Client.SendMsg("four"), Contains("4 bytes at once"));
  connection.Client.SendMsg("two");
  std::string message;
  connection.Server.RecvMsg(message);
  CHECK(message == "two");
  connection.Server.SendMsg("four");
  CTCPSocket moved(std::move(connection.Client));
  CHECK_THROWS_WITH(moved.RecvMsg(message), Contains("4 bytes, expected at most 3"));
}

TEST_CASE("socket: a port is open to this machine only unless an address is given",
          "[core][network]") {
  CTCPSocket listener;
  listener.Listen(0);
  CHECK(listener.GetAddress() == "127.0.0.1");
  listener.Listen(0, 10, "0.0.0.0");
  CHECK(listener.GetAddress() == "0.0.0.0");
  CHECK_THROWS_WITH(listener.Listen(0, 10, "no.such.address.invalid"),
                    Contains("cannot resolve \"no.such.address.invalid\""));
}

TEST_CASE("socket: failures are errors", "[core][network]") {
  CTCPSocket socket;
  UInt8 byte = 0;
  CHECK_THROWS_WITH(socket.SendBuffer(&byte, 1), Contains("cannot send, it is not connected"));
  CHECK_THROWS_WITH(socket.ReceiveBuffer(&byte, 1),
                    Contains("cannot receive, it is not connected"));
  CHECK_THROWS_WITH(socket.Accept(socket), Contains("it is not connected"));
  CHECK_THROWS_WITH(socket.GetPort(), Contains("it is not connected"));
  CHECK_THROWS_WITH(socket.Connect("127.0.0.1", 70000), Contains("port 70000, expected a number"));
  CHECK_THROWS_WITH(socket.Listen(-1), Contains("port -1"));
  CHECK_THROWS_WITH(socket.Connect("no host has blanks", 1), Contains("cannot resolve"));

  CTCPSocket listener;
  listener.Listen(0);
  const SInt32 port = listener.GetPort();
  CTCPSocket second;
  CHECK_THROWS_WITH(second.Listen(port), Contains("cannot listen on port"));
  listener.Disconnect();
  CHECK_THROWS_WITH(socket.Connect("127.0.0.1", port), Contains("cannot connect to \"127.0.0.1\""));

  SConnection connection;
  connection.Client.Disconnect();
  CHECK_THROWS_WITH(connection.Server.ReceiveBuffer(&byte, 1), Contains("the other side closed"));
  CHECK_FALSE(connection.Server.IsConnected());
}

}  // namespace tcp_socket_test
