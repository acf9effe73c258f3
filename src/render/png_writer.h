#pragma once

#include "base/problem.h"
#include "render/picture.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace tumble::render {

/// The bytes of a PNG file, three channels, with the picture's dots per metre where it says any. Throws std::bad_alloc.
std::vector<std::uint8_t> encode_png(const Picture& picture);

/// Writes pictures on a thread of its own, since encoding takes longer than drawing. At most `room` pictures wait;
/// add() waits when there are more. A file appears under its name only once it is whole.
class PngWriter {
public:
    explicit PngWriter(std::size_t room = 4);
    PngWriter(PngWriter&&) noexcept;
    PngWriter& operator=(PngWriter&&) noexcept;
    /// Finishes what was added.
    ~PngWriter();

    /// The problem of an earlier picture comes back with the next call; nothing is written after it until finish().
    Result<Done> add(std::filesystem::path file, Picture picture);

    /// What finish() would say, without waiting: nothing while a picture is still at work.
    std::optional<Result<Done>> outcome();

    /// Waits until all files are written, and tells of what was not; after that all begins anew.
    Result<Done> finish();

private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

} // namespace tumble::render
