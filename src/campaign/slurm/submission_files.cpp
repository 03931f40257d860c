#include <argos3/campaign/slurm/submission_files.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace fs = std::filesystem;

namespace argos {

namespace {

std::string MakeSibling(const SCampaign& campaign, const std::string& extension) {
  return fs::absolute(campaign.ResultsFile)
      .lexically_normal()
      .replace_extension(extension)
      .string();
}

}  // namespace

SSubmissionPaths::SSubmissionPaths(const SCampaign& campaign)
    : Folder(MakeSibling(campaign, ".slurm")),
      Parts(MakeSibling(campaign, ".parts")),
      JobsFile(Folder + "/jobs") {}

std::vector<std::string> SSubmittedJobs::List() const {
  return Merging.empty() ? std::vector<std::string>{Runs} : std::vector<std::string>{Runs, Merging};
}

std::vector<SSubmittedJobs> ReadJobs(const SSubmissionPaths& paths) {
  std::vector<SSubmittedJobs> all;
  std::ifstream file(paths.JobsFile);
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') {
      continue;
    }
    std::istringstream stream(line);
    SSubmittedJobs jobs;
    if (!(stream >> jobs.Number >> jobs.Runs)) {
      THROW_ARGOSEXCEPTION("\"" << paths.JobsFile << "\" has a line that is none of a submission: "
                                << line << "; remove the file if none of its jobs is queued");
    }
    stream >> jobs.Merging;
    all.push_back(jobs);
  }
  return all;
}

void WriteJobs(const SSubmissionPaths& paths, const SSubmittedJobs& jobs) {
  std::string text = "# submission, array job, merging job\n";
  std::vector<SSubmittedJobs> all = ReadJobs(paths);
  std::erase_if(all, [&](const SSubmittedJobs& other) { return other.Number == jobs.Number; });
  all.push_back(jobs);
  for (const SSubmittedJobs& one : all) {
    text += std::to_string(one.Number) + " " + one.Runs + " " + one.Merging + "\n";
  }
  WriteTextFile(paths.JobsFile, text);
}

std::vector<std::string> ListParts(const SSubmissionPaths& paths) {
  std::vector<std::string> parts;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(paths.Parts, error)) {
    if (entry.path().extension() == ".sqlite") {
      parts.push_back(entry.path().string());
    }
  }
  std::sort(parts.begin(), parts.end());
  return parts;
}

void WriteTextFile(const std::string& path, const std::string& text) {
  const std::string temporary = path + ".new";
  std::ofstream file(temporary);
  file << text;
  file.close();
  if (!file || std::rename(temporary.c_str(), path.c_str()) != 0) {
    THROW_ARGOSEXCEPTION("\"" << path << "\" cannot be written: " << std::strerror(errno));
  }
}

}  // namespace argos
