#include <argos3/core/utility/profiler/profiler.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/writing.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <sys/resource.h>

#include <iomanip>
#include <sstream>

namespace argos {

namespace {

Real Seconds(std::chrono::steady_clock::duration duration) {
  return std::chrono::duration<Real>(duration).count();
}

Real Seconds(const timeval& time) {
  return static_cast<Real>(time.tv_sec) + static_cast<Real>(time.tv_usec) * 1e-6;
}

}  // namespace

void CProfiler::Check(const std::string& file, const std::string& format) {
  if (format != "table" && format != "human_readable") {
    THROW_ARGOSEXCEPTION("Profiler: format \"" << format
                                               << "\", expected \"human_readable\" or \"table\"");
  }
  const std::string problem = FindOutputProblem(file, EMissingFolder::IsAProblem);
  if (!problem.empty()) {
    THROW_ARGOSEXCEPTION("Profiler: cannot write the file \"" << file << "\": " << problem);
  }
}

CProfiler::CProfiler(const std::string& file, const std::string& format, bool truncate)
    : m_file(file), m_isTable(format == "table") {
  Check(file, format);
  // report a file that cannot be written before the run, not after it. A table to which several
  // runs append is opened again at the end
  try {
    m_output.Open(file, truncate ? COutputFile::EStart::Truncate : COutputFile::EStart::Append);
  } catch (const CARGoSException&) {
    THROW_ARGOSEXCEPTION("Profiler: " << m_output.GetFailure());
  }
  if (!truncate) {
    m_output.Close();
  }
}

// measuring

void CProfiler::Start() {
  m_start = TClock::now();
  m_end = m_start;
}

void CProfiler::AddPhase(const std::string& name, Real seconds, UInt64 count) {
  m_phases.push_back({name, seconds, count});
}

CProfiler::SUsage CProfiler::GetUsage(int who) {
  rusage raw{};
  getrusage(who, &raw);
  SUsage usage;
  usage.UserTime = Seconds(raw.ru_utime);
  usage.SystemTime = Seconds(raw.ru_stime);
  usage.PeakMemory = raw.ru_maxrss;
  usage.MinorFaults = raw.ru_minflt;
  usage.MajorFaults = raw.ru_majflt;
  usage.VoluntarySwitches = raw.ru_nvcsw;
  usage.InvoluntarySwitches = raw.ru_nivcsw;
  return usage;
}

void CProfiler::CollectThreadResourceUsage() {
  const SUsage usage = GetUsage(RUSAGE_THREAD);
  const std::lock_guard<std::mutex> lock(m_threadMutex);
  m_threads.push_back(usage);
}

void CProfiler::Stop() {
  m_end = TClock::now();
  m_usage = GetUsage(RUSAGE_SELF);
}

Real CProfiler::GetWallTime() const {
  return Seconds(m_end - m_start);
}

// writing

std::string CProfiler::FormatReport() const {
  CTextOutput text;
  text << std::fixed << std::setprecision(6);
  text << "wall time (s)                 " << GetWallTime() << '\n'
       << "user time (s)                 " << m_usage.UserTime << '\n'
       << "system time (s)               " << m_usage.SystemTime << '\n'
       << "peak resident memory (KiB)    " << m_usage.PeakMemory << '\n'
       << "minor page faults             " << m_usage.MinorFaults << '\n'
       << "major page faults             " << m_usage.MajorFaults << '\n'
       << "voluntary context switches    " << m_usage.VoluntarySwitches << '\n'
       << "involuntary context switches  " << m_usage.InvoluntarySwitches << '\n';
  for (const SPhase& phase : m_phases) {
    const Real wallTime = GetWallTime();
    text << "phase \"" << phase.Name << "\": " << phase.Seconds << " s, "
         << (wallTime > 0.0 ? 100.0 * phase.Seconds / wallTime : 0.0) << " % of the wall time, "
         << phase.Count << " times, "
         << (phase.Count > 0 ? 1e6 * phase.Seconds / static_cast<Real>(phase.Count) : 0.0)
         << " us each\n";
  }
  for (std::size_t i = 0; i < m_threads.size(); ++i) {
    text << "thread " << i << ": " << m_threads[i].UserTime << " s user, "
         << m_threads[i].SystemTime << " s system\n";
  }
  text << '\n';
  return text.str();
}

std::string CProfiler::FormatTable(bool withHeader) const {
  CTextOutput text;
  if (withHeader) {
    text << "wall_s\tuser_s\tsystem_s\tpeak_memory_kib\tminor_faults\tmajor_faults\t"
         << "voluntary_switches\tinvoluntary_switches";
    for (const SPhase& phase : m_phases) {
      text << '\t' << phase.Name << "_s";
    }
    text << '\n';
  }
  text << std::fixed << std::setprecision(6) << GetWallTime() << '\t' << m_usage.UserTime << '\t'
       << m_usage.SystemTime << '\t' << m_usage.PeakMemory << '\t' << m_usage.MinorFaults << '\t'
       << m_usage.MajorFaults << '\t' << m_usage.VoluntarySwitches << '\t'
       << m_usage.InvoluntarySwitches;
  for (const SPhase& phase : m_phases) {
    text << '\t' << phase.Seconds;
  }
  text << '\n';
  return text.str();
}

void CProfiler::Flush() {
  try {
    if (!m_output.IsOpen()) {
      m_output.Open(m_file, COutputFile::EStart::Append);
    }
    m_output << (m_isTable ? FormatTable(m_output.GetSize() == 0) : FormatReport());
    m_output.Close();
  } catch (const CARGoSException&) {
    THROW_ARGOSEXCEPTION("Profiler: " << m_output.GetFailure());
  }
}

}  // namespace argos
