#include <argos3/plugins/simulator/visualizations/povray/povray_renderer.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/file_replacement.h>
#include <argos3/support/child_process.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <system_error>

namespace argos {

std::string GetPovrayProgram() {
  const char* const program = std::getenv("ARGOS_POVRAY");
  return program == nullptr || *program == '\0' ? "povray" : program;
}

namespace {

// POV-Ray splits its arguments again, and takes quotes at the start of a value only
std::string MakeFileArgument(const char* letter, const char* option, const std::string& name) {
  constexpr char kPlain[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+.";
  if (name.find_first_not_of(kPlain) == std::string::npos) {
    return letter + name;
  }
  const char quote = name.find('"') == std::string::npos ? '"' : '\'';
  return option + std::string("=") + quote + name + quote;
}

}  // namespace

void CheckPovrayName(const std::string& name) {
  const bool hasBothQuotes =
      name.find('"') != std::string::npos && name.find('\'') != std::string::npos;
  const bool isPlain =
      std::all_of(name.begin(), name.end(), [](unsigned char c) { return c < 0x80; });
  if (hasBothQuotes || !isPlain) {
    THROW_ARGOSEXCEPTION("POV-Ray cannot open files whose names begin with \""
                         << name
                         << "\": it accepts ASCII characters only, and one of the two quotation "
                            "marks; write another base_name, or render=\"false\"");
  }
}

std::vector<std::string> MakePovrayArguments(const SPovrayJob& job, const std::string& scene,
                                             const std::string& picture) {
  std::vector<std::string> arguments = {MakeFileArgument("+I", "Input_File_Name", scene),
                                        MakeFileArgument("+O", "Output_File_Name", picture),
                                        fmt::format("+W{}", job.Width),
                                        fmt::format("+H{}", job.Height),
                                        "-D",
                                        "+FN8",
                                        "-GS",
                                        "-GR",
                                        "-GD"};
  switch (job.Quality) {
    case EPovrayQuality::Draft:
      arguments.insert(arguments.end(), {"+A0.3", "+AM1", "+R2"});
      break;
    case EPovrayQuality::Good:
      arguments.insert(arguments.end(), {"+A0.15", "+AM2", "+R2"});
      break;
    case EPovrayQuality::Best:
      arguments.insert(arguments.end(), {"+A0.04", "+AM2", "+R3"});
      break;
  }
  if (job.Threads > 0) {
    arguments.push_back(fmt::format("+WT{}", job.Threads));
  }
  return arguments;
}

std::string FindPovrayErrors(const std::string& messages) {
  std::string errors;
  std::istringstream lines(messages);
  std::string line;
  while (std::getline(lines, line)) {
    const bool isError = line.find("rror") != std::string::npos ||
                         line.find("annot") != std::string::npos ||
                         line.find("enied") != std::string::npos || line.rfind("File '", 0) == 0;
    if (isError && line.find("user configuration file") == std::string::npos) {
      errors += (errors.empty() ? "" : "\n") + line;
    }
  }
  return errors.empty() ? messages : errors;
}

CPovrayRenderer::CPovrayRenderer(const SPovrayJob& job) : m_job(job), m_thread([this] { Run(); }) {}

CPovrayRenderer::~CPovrayRenderer() {
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_isClosed = true;
    m_waiting.clear();
  }
  m_changed.notify_all();
  m_thread.join();
}

void CPovrayRenderer::Submit(const std::string& scene) {
  std::unique_lock<std::mutex> lock(m_mutex);
  m_changed.wait(lock, [this] { return m_waiting.size() < kMaxWaiting || m_error != nullptr; });
  ThrowError();
  m_waiting.push_back(scene);
  m_changed.notify_all();
}

void CPovrayRenderer::Finish() {
  std::unique_lock<std::mutex> lock(m_mutex);
  m_changed.wait(lock, [this] { return m_waiting.empty() && !m_isRendering; });
  ThrowError();
}

void CPovrayRenderer::ThrowError() {
  if (m_error != nullptr) {
    std::exception_ptr error;
    std::swap(error, m_error);
    std::rethrow_exception(error);
  }
}

void CPovrayRenderer::Run() {
  std::unique_lock<std::mutex> lock(m_mutex);
  while (true) {
    m_changed.wait(lock, [this] { return !m_waiting.empty() || m_isClosed; });
    if (m_waiting.empty()) {
      return;
    }
    const std::string scene = m_waiting.front();
    m_waiting.pop_front();
    m_isRendering = true;
    m_changed.notify_all();
    lock.unlock();
    std::exception_ptr error;
    try {
      Render(scene);
    } catch (...) {
      error = std::current_exception();
    }
    lock.lock();
    m_isRendering = false;
    if (error != nullptr) {
      m_error = error;
      m_waiting.clear();
    }
    m_changed.notify_all();
  }
}

void CPovrayRenderer::Render(const std::string& scene) const {
  const std::string picture = scene.substr(0, scene.rfind('.')) + ".png";
  // POV-Ray appends .png to other endings
  const std::string part = picture + kPartSuffix + ".png";
  std::vector<std::string> arguments = MakePovrayArguments(m_job, scene, part);
  arguments.insert(arguments.begin(), GetPovrayProgram());
  // POV-Ray gives its own threads a few seconds to start, which is too short on a busy machine
  constexpr std::size_t kMaxStarts = 3;
  std::string messages;
  SProcessEnd end;
  std::size_t starts = 0;
  do {
    CChildProcess povray(arguments, m_job.Directory);
    end = povray.Finish();
    messages = povray.GetErrorText();
  } while (!end.IsSuccess && ++starts < kMaxStarts &&
           messages.find("waiting for worker thread startup") != std::string::npos);
  const std::filesystem::path folder(m_job.Directory);
  std::error_code error;
  if (end.IsSuccess) {
    std::filesystem::rename(folder / part, folder / picture, error);
    if (!error) {
      return;
    }
  }
  const std::string problem = error ? error.message() : end.Description;
  std::filesystem::remove(folder / part, error);
  THROW_ARGOSEXCEPTION("POV-Ray (\"" << arguments.front() << "\") cannot render \""
                                     << (folder / scene).string() << "\": " << problem << "\n"
                                     << FindPovrayErrors(messages));
}

}  // namespace argos
