#include "view/jpeg.h"

#include <turbojpeg.h>

namespace tumble::view {

JpegEncoder::JpegEncoder(int quality) : handle_(tjInitCompress(), tjDestroy), quality_(quality) {}

Result<std::vector<std::uint8_t>> JpegEncoder::encode(const render::Picture& picture) {
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    const int failed = tjCompress2(handle_.get(), picture.rgba.data(), picture.width, 0, picture.height, TJPF_RGBX,
                                   &bytes, &size, TJSAMP_444, quality_, TJFLAG_FASTDCT);
    const std::unique_ptr<unsigned char, decltype(&tjFree)> owner(bytes, tjFree);
    if (failed != 0)
        return Problem{.what = std::string("a frame could not be packed as JPEG: ") + tjGetErrorStr2(handle_.get()),
                       .fix = "make the window smaller"};
    return std::vector<std::uint8_t>(bytes, bytes + size);
}

} // namespace tumble::view
