#include <argos3/plugins/simulator/outputs/tables/table_base.h>

#include <argos3/core/simulator/loading/loading_check.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/writing.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/plugins/dynamic_loading.h>
#include <argos3/plugins/simulator/outputs/tables/run_header.h>

#include <cmath>

namespace argos {

namespace {

constexpr int kMaxDigits = 17;

bool EndsWith(const std::string& text, const std::string& end) {
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// "csv" for "poses.csv"
std::unique_ptr<CTableFormat> MakeFormat(const std::string& path) {
  if (EndsWith(path, ".h5")) {
    // libhdf5 brings 30 other libraries along, which only those load that use it
    try {
      CDynamicLoading::LoadLibrary("on_demand/libargos3_hdf5_tables");
    } catch (CARGoSException& ex) {
      THROW_ARGOSEXCEPTION_NESTED("\"" << path
                                       << "\" cannot be written as HDF5: the library for it "
                                       << "is built where HDF5 is installed (Debian: libhdf5-dev); "
                                       << "\"file\" may end in .csv or .csv.gz instead",
                                  ex);
    }
  }
  for (const char* const ending : {"csv", "csv.gz", "h5"}) {
    if (EndsWith(path, std::string(".") + ending)) {
      return std::unique_ptr<CTableFormat>(CFactory<CTableFormat>::New(ending));
    }
  }
  THROW_ARGOSEXCEPTION("\"file\" must end in .csv, .csv.gz (compressed) or .h5 (HDF5), found \""
                       << path << '"');
}

// a file that cannot be written is found before the run; an old file stays as it is
void CheckCanBeWritten(const std::string& path) {
  const std::string problem = FindOutputProblem(
      path, CLoadingCheck::IsActive() ? EMissingFolder::WillBeCreated : EMissingFolder::IsCreated);
  if (!problem.empty()) {
    THROW_ARGOSEXCEPTION("cannot write the file \"" << path << "\": " << problem);
  }
}

}  // namespace

void CTableBase::Init(TConfigurationNode& tree) {
  m_location = tree.GetLocation();
  m_location += ": <";
  m_location += tree.Value();
  m_location += '>';
  GetNodeAttribute(tree, "file", m_path);
  GetNodeAttributeOrDefault(tree, "every", m_every, m_every);
  if (m_every == 0) {
    THROW_ARGOSEXCEPTION(m_location
                         << ": \"every\" must be a number of ticks, at least 1, found 0");
  }
  if (NodeAttributeExists(tree, "digits")) {
    GetNodeAttribute(tree, "digits", m_digits);
    if (m_digits < 1 || m_digits > kMaxDigits) {
      THROW_ARGOSEXCEPTION(m_location << ": \"digits\" must be from 1 to " << kMaxDigits
                                      << "; without it, numbers have as many as they need; found "
                                      << m_digits);
    }
  }
  try {
    std::unique_ptr<CTableFormat> format = MakeFormat(m_path);
    CheckCanBeWritten(m_path);
    m_writer = std::make_unique<CTableWriter>(m_path, std::move(format));
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(m_location, error);
  }
}

void CTableBase::Open(CSimulator& simulator) {
  STableSchema schema;
  schema.Version = GetVersionText();
  schema.Digits = m_digits;
  schema.Header = DescribeRun(simulator);
  schema.Header.emplace_back("every", std::to_string(m_every));
  for (auto& entry : DescribeArena(simulator)) {
    schema.Header.push_back(std::move(entry));
  }
  Describe(schema);
  m_writer->Open(schema);
}

bool CTableBase::IsWanted(const CSimulator& simulator) const {
  return simulator.GetSpace().GetSimulationClock() % m_every == 0;
}

SRowBlock::STick CTableBase::MakeTick(const CSimulator& simulator) const {
  const UInt32 tick = simulator.GetSpace().GetSimulationClock();
  // a quotient has fewer digits than a multiple of 0.1
  const double time = tick / std::round(1.0 / simulator.GetTickLength());
  return {m_run, simulator.GetRandomSeed(), tick, time, 0};
}

void CTableBase::Observe(CSimulator& simulator) {
  if (IsWanted(simulator)) {
    AppendTick(simulator, MakeTick(simulator));
  }
}

void CTableBase::AppendTick(CSimulator& simulator, SRowBlock::STick tick) {
  if (Update(simulator) && m_writer->CanOpen()) {
    Open(simulator);
  }
  SRowBlock& block = m_writer->GetBlock();
  tick.NumRows = Read(simulator, block);
  block.Ticks.push_back(tick);
  if (m_writer->IsOpen()) {
    m_writer->EndTick();
  }
}

void CTableBase::Finish(CSimulator& simulator) {
  if (m_writer == nullptr) {
    return;
  }
  if (m_writer->CanOpen()) {
    Update(simulator);
    if (m_writer->GetBlock().NumRows == 0) {
      LOGERR << "[WARNING] " << m_location << ": no rows were written to \"" << m_path
             << "\": " << ExplainEmptyTable() << std::endl;
    }
    // an old file would be taken for the result
    Open(simulator);
  }
  m_writer->Finish();
}

void CTableBase::Destroy() {
  if (m_writer != nullptr) {
    m_writer->Close();
  }
}

}  // namespace argos
