#include <argos3/plugins/simulator/outputs/recording/format/recording_info.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <cmath>

namespace argos {

namespace {

// names in the file
constexpr char kExperimentFile[] = "experiment_file";
constexpr char kExperiment[] = "experiment";
constexpr char kOverridePath[] = "override_path";
constexpr char kOverrideValue[] = "override_value";
constexpr char kSeed[] = "seed";
constexpr char kVersion[] = "version";
constexpr char kBuild[] = "build";
constexpr char kDate[] = "date";
constexpr char kTickLength[] = "tick_length";
constexpr char kEvery[] = "every";
constexpr char kPrecision[] = "precision";

template <typename WRITE>
std::string ToBytes(WRITE&& write) {
  std::string bytes;
  CByteWriter out(bytes);
  write(out);
  return bytes;
}

std::string NumberText(UInt64 number) {
  return ToBytes([number](CByteWriter& out) { out.WriteNumber(number); });
}

UInt32 ReadUInt32(std::string_view text, const char* what) {
  return static_cast<UInt32>(CByteReader(text).ReadNumberUpTo(~UInt32(0), what));
}

void ReadEntry(std::string_view name, std::string_view value, SRecordingInfo& info) {
  if (name == kExperimentFile) {
    info.ExperimentFile = value;
  } else if (name == kExperiment) {
    info.Experiment = value;
  } else if (name == kOverridePath) {
    info.Overrides.emplace_back(value, "");
  } else if (name == kOverrideValue && !info.Overrides.empty()) {
    info.Overrides.back().second = value;
  } else if (name == kSeed) {
    info.Seed = ReadUInt32(value, "seed");
  } else if (name == kVersion) {
    info.Version = value;
  } else if (name == kBuild) {
    info.Build = value;
  } else if (name == kDate) {
    info.Date = value;
  } else if (name == kTickLength) {
    info.TickLength = CByteReader(value).ReadReal();
  } else if (name == kEvery) {
    info.Every = ReadUInt32(value, "number of ticks from frame to frame");
  } else if (name == kPrecision) {
    info.Precision = static_cast<EPrecision>(
        CByteReader(value).ReadNumberUpTo(static_cast<UInt64>(EPrecision::Exact), "precision"));
  }
}

}  // namespace

std::string WriteInfo(const SRecordingInfo& info) {
  return ToBytes([&info](CByteWriter& out) {
    const auto add = [&out](const char* name, std::string_view value) {
      out.WriteText(name);
      out.WriteText(value);
    };
    add(kExperimentFile, info.ExperimentFile);
    add(kExperiment, info.Experiment);
    for (const auto& [path, value] : info.Overrides) {
      add(kOverridePath, path);
      add(kOverrideValue, value);
    }
    add(kSeed, NumberText(info.Seed));
    add(kVersion, info.Version);
    add(kBuild, info.Build);
    add(kDate, info.Date);
    add(kTickLength, ToBytes([&info](CByteWriter& value) { value.WriteReal(info.TickLength); }));
    add(kEvery, NumberText(info.Every));
    add(kPrecision, NumberText(static_cast<UInt64>(info.Precision)));
  });
}

SRecordingInfo ReadInfo(std::string_view bytes) {
  SRecordingInfo info;
  CByteReader in(bytes);
  while (!in.IsAtEnd()) {
    const std::string_view name = in.ReadText();
    ReadEntry(name, in.ReadText(), info);
  }
  if (!(info.TickLength > 0.0) || !std::isfinite(info.TickLength)) {
    THROW_ARGOSEXCEPTION("its length of a tick is " << info.TickLength << " s");
  }
  return info;
}

}  // namespace argos
