#pragma once

#include "base/problem.h"
#include "render/picture.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace tumble::view {

/// Pictures as JPEG, colours at full resolution: thin coloured lines and letters would smear otherwise.
class JpegEncoder {
public:
    /// `quality` 1 to 100.
    explicit JpegEncoder(int quality);

    /// The bytes of a JPEG file; opacity is left out. Problems: memory that ran out, a picture beyond 65535 pixels.
    Result<std::vector<std::uint8_t>> encode(const render::Picture& picture);

private:
    std::shared_ptr<void> handle_;
    int quality_;
};

} // namespace tumble::view
