#ifndef ARGOS3_CORE_SIMULATOR_IMAGES_IMAGE_ENCODING_H
#define ARGOS3_CORE_SIMULATOR_IMAGES_IMAGE_ENCODING_H

#include <string>

struct FIBITMAP;

namespace argos {

/**
 * Encodes a picture as the content of a file, for ReplaceFile(): FreeImage's own functions ignore
 * failed writes, and overflow a buffer with the message on a long path.
 * @param format  a FREE_IMAGE_FORMAT.
 * @param flags   of that format.
 * @throws CARGoSException with FreeImage's reason.
 */
std::string EncodeImage(FIBITMAP& bitmap, int format, int flags);

}  // namespace argos

#endif
