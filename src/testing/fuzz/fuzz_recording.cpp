// The input is a recording; the first byte says how it is read: 0 as a file, else as the content of
// a block of states, which checksums would otherwise keep from the decoder.

#include <argos3/testing/fuzz/fuzz_support.h>

#include <argos3/plugins/simulator/outputs/recording/format/recording_reader.h>

#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <string_view>

using namespace argos;

namespace {

void ReadAsFile(std::string_view bytes) {
  const int file = memfd_create("recording", MFD_CLOEXEC);
  if (file < 0 || write(file, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) {
    std::abort();
  }
  try {
    CRecordingReader reader("/proc/self/fd/" + std::to_string(file));
    while (reader.ReadNext() != nullptr) {
    }
  } catch (...) {
    close(file);
    throw;
  }
  close(file);
}

void ReadAsFrames(std::string_view bytes, EPrecision precision) {
  CByteReader in(bytes);
  CFrameDecoder decoder(precision);
  decoder.SetFloor(std::make_shared<SRecordedFloor>(SRecordedFloor{2, 2, std::string(12, 'a')}));
  for (bool isKey = true; !in.IsAtEnd(); isKey = false) {
    decoder.Decode(in, isKey);
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return RunFuzzInput([data, size] {
    if (size == 0) {
      return;
    }
    const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    switch (data[0] % 3) {
      case 0:
        ReadAsFile(bytes);
        break;
      case 1:
        ReadAsFrames(bytes, EPrecision::Grid);
        break;
      default:
        ReadAsFrames(bytes, EPrecision::Exact);
        break;
    }
  });
}
