#include <argos3/core/simulator/images/image_encoding.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <FreeImage.h>

#include <memory>

namespace argos {

namespace {

struct SMemoryCloser {
  void operator()(FIMEMORY* memory) const { FreeImage_CloseMemory(memory); }
};

// FreeImage passes messages to a function without context
thread_local std::string t_encodingProblem;

void NoteEncodingProblem(FREE_IMAGE_FORMAT, const char* message) {
  t_encodingProblem = message;
}

}  // namespace

std::string EncodeImage(FIBITMAP& bitmap, int format, int flags) {
  const auto type = static_cast<FREE_IMAGE_FORMAT>(format);
  t_encodingProblem.clear();
  FreeImage_SetOutputMessage(&NoteEncodingProblem);
  const std::unique_ptr<FIMEMORY, SMemoryCloser> memory(FreeImage_OpenMemory());
  BYTE* content = nullptr;
  DWORD size = 0;
  if (memory == nullptr || !FreeImage_SaveToMemory(type, &bitmap, memory.get(), flags) ||
      !FreeImage_AcquireMemory(memory.get(), &content, &size) || size == 0) {
    THROW_ARGOSEXCEPTION("a picture of "
                         << FreeImage_GetWidth(&bitmap) << "x" << FreeImage_GetHeight(&bitmap)
                         << " pixels cannot be stored as " << FreeImage_GetFormatFromFIF(type)
                         << (t_encodingProblem.empty() ? "" : ": ") << t_encodingProblem);
  }
  return std::string(reinterpret_cast<const char*>(content), size);
}

}  // namespace argos
