#include <argos3/plugins/simulator/visualizations/live/server/request_checks.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace argos {

namespace {

std::string ToLower(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

// "[::1]" of "[::1]:8000"; empty if it is no host
std::string_view WithoutPort(std::string_view host) {
  const size_t bracket = host.find(']');
  const size_t start = bracket == std::string_view::npos ? 0 : bracket;
  const size_t colon = host.find(':', start);
  if (colon == std::string_view::npos) {
    return host;
  }
  const std::string_view port = host.substr(colon + 1);
  const bool isNumber = !port.empty() && std::all_of(port.begin(), port.end(), [](unsigned char c) {
    return std::isdigit(c) != 0;
  });
  return isNumber ? host.substr(0, colon) : std::string_view();
}

// the computer's name is unknown where the server listens on all addresses: these are no names
bool IsAddress(std::string_view host) {
  return !host.empty() &&
         (host.front() == '[' || host.find_first_not_of("0123456789.") == std::string_view::npos);
}

bool ListensOnAll(const std::string& address) {
  return address == "0.0.0.0" || address == "::";
}

}  // namespace

std::string MakeLiveToken() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    THROW_ARGOSEXCEPTION("the system gives no random numbers, which the URL of a live view needs");
  }
  constexpr char kDigits[] = "0123456789abcdef";
  std::string token;
  for (const unsigned char byte : bytes) {
    token += kDigits[byte >> 4];
    token += kDigits[byte & 15];
  }
  return token;
}

bool IsSameToken(std::string_view given, std::string_view expected) {
  if (given.size() != expected.size()) {
    return false;
  }
  unsigned char difference = 0;
  for (size_t i = 0; i < given.size(); ++i) {
    difference |= static_cast<unsigned char>(given[i] ^ expected[i]);
  }
  return difference == 0;
}

bool IsAllowedHost(std::string_view host, const SLiveAccess& access) {
  const std::string name = ToLower(WithoutPort(host));
  if (name == "localhost" || name == "127.0.0.1" || name == "[::1]") {
    return true;
  }
  if (ListensOnAll(access.Address) ? IsAddress(name)
                                   : name == access.Address || name == '[' + access.Address + ']') {
    return !name.empty();
  }
  return std::any_of(access.Hosts.begin(), access.Hosts.end(), [&](const std::string& allowed) {
    return !name.empty() && ToLower(allowed) == name;
  });
}

bool IsAllowedOrigin(std::string_view origin, std::string_view host) {
  return origin.empty() || origin == "http://" + std::string(host) ||
         origin == "https://" + std::string(host);
}

bool AcceptsGzip(std::string_view encodings) {
  std::vector<std::string> accepted;
  Tokenize(ToLower(encodings), accepted, ", ");
  return std::find(accepted.begin(), accepted.end(), "gzip") != accepted.end();
}

}  // namespace argos
