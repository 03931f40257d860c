#include <argos3/campaign/execution/run_messages.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/support/byte_stream.h>

#include <limits>

namespace argos {

namespace {

UInt32 ReadUInt32(CByteReader& reader, const char* what) {
  return static_cast<UInt32>(reader.ReadNumberUpTo(std::numeric_limits<UInt32>::max(), what));
}

void ThrowUnlessAtEnd(const CByteReader& reader) {
  if (!reader.IsAtEnd()) {
    THROW_ARGOSEXCEPTION("a message of the campaign is longer than its contents");
  }
}

void WriteSeries(CByteWriter& writer, const SMetricSeries& series) {
  writer.WriteText(series.Name);
  writer.WriteText(series.Unit);
  writer.WriteNumber(series.Ticks.size());
  for (size_t i = 0; i < series.Ticks.size(); ++i) {
    writer.WriteNumber(series.Ticks[i]);
    writer.WriteReal(series.Values.at(i));
  }
}

SMetricSeries ReadSeries(CByteReader& reader) {
  SMetricSeries series;
  series.Name = reader.ReadText();
  series.Unit = reader.ReadText();
  const size_t count = reader.ReadCount("values of a series");
  for (size_t i = 0; i < count; ++i) {
    series.Ticks.push_back(ReadUInt32(reader, "tick of a series"));
    series.Values.push_back(reader.ReadReal());
  }
  return series;
}

void WriteMeasures(CByteWriter& writer, const SRunResult& result) {
  writer.WriteByte(static_cast<UInt8>(result.Status));
  writer.WriteSigned(result.ExitStatus);
  writer.WriteSigned(result.Signal);
  for (const Real time :
       {result.StartUpTime, result.WallTime, result.CPUTime, result.TotalWallTime}) {
    writer.WriteReal(time);
  }
  writer.WriteNumber(result.PeakMemory);
  writer.WriteNumber(result.Ticks);
  writer.WriteNumber(result.Robots);
  writer.WriteFixed64(result.Digest);
  writer.WriteText(result.Log);
  writer.WriteNumber(result.LogBytes);
  writer.WriteText(result.Error);
  writer.WriteNumber(result.Warnings.size());
  for (const std::string& warning : result.Warnings) {
    writer.WriteText(warning);
  }
}

void ReadMeasures(CByteReader& reader, SRunResult& result) {
  const UInt8 status = reader.ReadByte();
  if (status > static_cast<UInt8>(ERunStatus::Interrupted)) {
    THROW_ARGOSEXCEPTION("a message of the campaign has the unknown status " << int(status));
  }
  result.Status = static_cast<ERunStatus>(status);
  result.ExitStatus = static_cast<int>(reader.ReadSigned());
  result.Signal = static_cast<int>(reader.ReadSigned());
  for (Real* time :
       {&result.StartUpTime, &result.WallTime, &result.CPUTime, &result.TotalWallTime}) {
    *time = reader.ReadReal();
  }
  result.PeakMemory = reader.ReadNumber();
  result.Ticks = ReadUInt32(reader, "number of ticks");
  result.Robots = ReadUInt32(reader, "number of robots");
  result.Digest = reader.ReadFixed64();
  result.Log = reader.ReadText();
  result.LogBytes = reader.ReadNumber();
  result.Error = reader.ReadText();
  for (size_t count = reader.ReadCount("warnings"); count > 0; --count) {
    result.Warnings.emplace_back(reader.ReadText());
  }
}

}  // namespace

std::string EncodeRequest(const SRunRequest& request) {
  std::string bytes;
  CByteWriter writer(bytes);
  writer.WriteNumber(request.Id);
  writer.WriteNumber(request.Seed);
  writer.WriteText(request.Folder);
  writer.WriteNumber(request.Settings.size());
  for (const SSetting& setting : request.Settings) {
    writer.WriteText(setting.Path);
    writer.WriteText(setting.Value);
  }
  return bytes;
}

SRunRequest DecodeRequest(std::string_view bytes) {
  CByteReader reader(bytes);
  SRunRequest request;
  request.Id = reader.ReadNumber();
  request.Seed = ReadUInt32(reader, "seed");
  request.Folder = reader.ReadText();
  const size_t count = reader.ReadCount("settings");
  for (size_t i = 0; i < count; ++i) {
    SSetting& setting = request.Settings.emplace_back();
    setting.Path = reader.ReadText();
    setting.Value = reader.ReadText();
  }
  ThrowUnlessAtEnd(reader);
  return request;
}

std::string EncodeResult(UInt64 id, const SRunResult& result) {
  std::string bytes;
  CByteWriter writer(bytes);
  writer.WriteNumber(id);
  WriteMeasures(writer, result);
  writer.WriteNumber(result.Metrics.size());
  for (const SMetricValue& metric : result.Metrics) {
    writer.WriteText(metric.Name);
    writer.WriteText(metric.Unit);
    writer.WriteReal(metric.Value);
  }
  writer.WriteNumber(result.Series.size());
  for (const SMetricSeries& series : result.Series) {
    WriteSeries(writer, series);
  }
  return bytes;
}

std::pair<UInt64, SRunResult> DecodeResult(std::string_view bytes) {
  CByteReader reader(bytes);
  std::pair<UInt64, SRunResult> decoded;
  decoded.first = reader.ReadNumber();
  ReadMeasures(reader, decoded.second);
  const size_t numMetrics = reader.ReadCount("metrics");
  for (size_t i = 0; i < numMetrics; ++i) {
    SMetricValue& metric = decoded.second.Metrics.emplace_back();
    metric.Name = reader.ReadText();
    metric.Unit = reader.ReadText();
    metric.Value = reader.ReadReal();
  }
  const size_t numSeries = reader.ReadCount("series");
  for (size_t i = 0; i < numSeries; ++i) {
    decoded.second.Series.push_back(ReadSeries(reader));
  }
  ThrowUnlessAtEnd(reader);
  return decoded;
}

}  // namespace argos
