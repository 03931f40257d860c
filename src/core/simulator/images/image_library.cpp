#include <argos3/core/simulator/images/image_library.h>

#include <argos3/core/utility/plugins/dynamic_loading.h>
#include <argos3/core/utility/plugins/factory.h>

#include <filesystem>
#include <memory>
#include <system_error>

namespace argos {

namespace {

std::unique_ptr<const CImageLibrary> LoadImageLibrary() {
  CDynamicLoading::LoadLibrary("on_demand/libargos3_images");
  return std::unique_ptr<const CImageLibrary>(CFactory<CImageLibrary>::New("freeimage"));
}

const CImageLibrary& Library() {
  static const std::unique_ptr<const CImageLibrary> library = LoadImageLibrary();
  return *library;
}

}  // namespace

std::string DescribePath(const std::string& path) {
  std::error_code ignored;
  const std::string resolved = std::filesystem::absolute(path, ignored).lexically_normal().string();
  return resolved == path ? '"' + path + '"' : '"' + path + "\" (that is, \"" + resolved + "\")";
}

SImage ReadImage(const std::string& path, const std::string& what) {
  return Library().Read(path, what);
}

std::optional<SImageFormat> FindImageFormat(const std::string& fileName) {
  return Library().FindFormat(fileName);
}

std::string ListImageFormats() {
  return Library().ListFormats();
}

void SetQuality(SImageFormat& format, int quality) {
  Library().SetQuality(format, quality);
}

std::string EncodeImage(const SPixelView& picture, const SImageFormat& format) {
  return Library().Encode(picture, format);
}

}  // namespace argos
