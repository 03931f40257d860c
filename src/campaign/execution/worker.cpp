#include <argos3/campaign/execution/worker.h>

#include <argos3/campaign/execution/experiment_paths.h>
#include <argos3/campaign/execution/message_stream.h>
#include <argos3/campaign/execution/run_messages.h>
#include <argos3/campaign/execution/run_process.h>

#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/errors/exception_text.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/plugins/dynamic_loading.h>
#include <argos3/program/crash_handler.h>

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <optional>

namespace argos {

namespace {

void LoadLibraries(const SRunSetup& setup) {
  CDynamicLoading::LoadAllLibrariesByLabel();
  CConfigurationDocument document;
  ParseExperiment(setup, document);
  // here, and not in the process of each run
  CDynamicLoading::LoadLibrariesOfLabels(ListPluginLabels(document));
  for (const std::string& library : ListLibraries(document)) {
    try {
      CDynamicLoading::LoadLibrary(library);
    } catch (const CARGoSException&) {
      // a setting may replace the name; if none does, each run reports it
      LOG << "[INFO] \"" << library << "\" was not loaded" << std::endl;
    }
  }
  for (const SCollectedMetric& metric : setup.Metrics) {
    if (!metric.Library.empty()) {
      CDynamicLoading::LoadLibrary(MakeInputPathAbsolute(metric.Library, setup.StartFolder));
    }
  }
}

// messages about libraries would appear once for each worker
void SilenceStandardOutput() {
  const int null = open("/dev/null", O_RDWR | O_CLOEXEC);
  dup2(null, STDIN_FILENO);
  dup2(null, STDOUT_FILENO);
  close(null);
}

void Flush() {
  LOG.Flush();
  LOGERR.Flush();
  std::fflush(nullptr);
}

void ExecuteRequests(const SRunSetup& setup, int requests, int results) {
  CRunProcess process(setup, requests);
  CMessageReader reader;
  for (;;) {
    const std::optional<SMessage> message = reader.Take();
    if (!message) {
      if (!reader.Fill(requests)) {
        return;
      }
      continue;
    }
    const SRunRequest request = DecodeRequest(message->Body);
    const std::optional<SRunResult> result = process.Execute(request);
    if (!result ||
        !WriteMessage(results, SMessage::EKind::Result, EncodeResult(request.Id, *result))) {
      return;
    }
  }
}

}  // namespace

void PrepareWorker(const SRunSetup& setup) {
  SilenceStandardOutput();
  LOG.DisableColoredOutput();
  LOGERR.DisableColoredOutput();
  MakePluginPathAbsolute();
  LoadLibraries(setup);
  CCrashHandler::Install();
  // each fork would write what is buffered now
  Flush();
}

void RunWorker(const SRunSetup& setup, int requests, int results) {
  try {
    PrepareWorker(setup);
    ExecuteRequests(setup, requests, results);
  } catch (...) {
    WriteMessage(results, SMessage::EKind::Error, DescribeCurrentException());
    Flush();
    _exit(1);
  }
  _exit(0);
}

}  // namespace argos
