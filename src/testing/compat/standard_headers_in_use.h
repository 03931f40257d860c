#ifndef ARGOS3_TESTING_COMPAT_STANDARD_HEADERS_IN_USE_H
#define ARGOS3_TESTING_COMPAT_STANDARD_HEADERS_IN_USE_H

// Includes nothing: it is compiled behind standard_headers.h, which must bring all that this uses.

/** Uses something of each standard header that users' code gets with the headers of ARGoS. */
inline void UseStandardHeaders() {
  std::vector<double> values{2.0, 1.0};
  std::sort(values.begin(), values.end());
  std::map<int, double> byNumber{{1, std::sqrt(values[0])}};
  std::unordered_map<int, double> hashed{{1, std::atan2(values[0], values[1])}};
  std::function<double(double)> root = [](double x) { return std::sqrt(x); };

  std::ofstream file("/dev/null");
  std::ostringstream text;
  text << std::setw(8) << std::setprecision(3) << byNumber[1] << root(hashed[1]);
  file << text.str() << std::endl;
  std::cout << std::flush;
  std::cerr << std::flush;

  char from[8] = "a";
  char to[8];
  memset(to, 0, sizeof(to));
  memcpy(to, from, sizeof(to));
  if (strlen(to) != std::strlen(from) || getpid() == 0) {
    throw std::runtime_error(std::string("text"));
  }
  std::snprintf(to, sizeof(to), "%d", std::atoi(from));
  std::printf("%s %d\n", to, std::rand() % 2);
  usleep(0);
}

#endif
