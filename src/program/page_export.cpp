#include <argos3/program/page_export.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/input_file.h>
#include <argos3/core/utility/files/writing.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>

namespace argos {

namespace {

constexpr char kMagic[] = "ARGOSREC";

std::string ReadRecording(const std::string& path) {
  std::string bytes;
  std::string problem;
  if (!ReadInputFile(path, bytes, problem)) {
    THROW_ARGOSEXCEPTION("cannot open the recording \"" << path << "\": " << problem);
  }
  if (bytes.compare(0, sizeof(kMagic) - 1, kMagic) != 0) {
    THROW_ARGOSEXCEPTION('"' << path << "\" is no recording: it does not begin with \"" << kMagic
                             << '"');
  }
  return bytes;
}

std::string ToBase64(const std::string& bytes) {
  constexpr char kBase64Digits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  constexpr std::size_t kGroup = 3;
  std::string text;
  text.reserve((bytes.size() + kGroup - 1) / kGroup * 4);
  for (std::size_t i = 0; i < bytes.size(); i += kGroup) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < kGroup; ++k) {
      const auto byte = i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0;
      group = group << 8 | byte;
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? kBase64Digits[group >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

// it precedes the scripts of the page, which look for it
std::size_t FindPlace(const std::string& page) {
  const std::size_t body = page.find("<body");
  const std::size_t end = body == std::string::npos ? body : page.find('>', body);
  if (end == std::string::npos) {
    THROW_ARGOSEXCEPTION("the page of the live view is damaged: it has no <body>");
  }
  return end + 1;
}

}  // namespace

void ExportPage(const std::string& recording, const std::string& file, const std::string& prefix) {
  const std::string path = prefix + "/share/argos3/live/index.html";
  std::string page;
  std::string problem;
  if (!ReadInputFile(path, page, problem)) {
    THROW_ARGOSEXCEPTION("--html needs the page of the live view, \""
                         << path
                         << "\", which is built where npm is installed (Debian: nodejs npm)");
  }
  const std::string data = ToBase64(ReadRecording(recording));
  const std::size_t place = FindPlace(page);
  problem = FindOutputProblem(file, EMissingFolder::IsCreated);
  if (!problem.empty()) {
    THROW_ARGOSEXCEPTION("cannot write \"" << file << "\": " << problem);
  }
  const std::string part = file + ".part";
  std::ofstream out(part, std::ios::binary | std::ios::trunc);
  out << page.substr(0, place)
      << "<script type=\"application/octet-stream;base64\" id=\"recording\">" << data << "</script>"
      << page.substr(place);
  out.close();
  if (!out || std::rename(part.c_str(), file.c_str()) != 0) {
    static_cast<void>(std::remove(part.c_str()));
    THROW_ARGOSEXCEPTION("cannot write \"" << file << "\" completely");
  }
}

}  // namespace argos
