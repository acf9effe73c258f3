#include "base/checksum.h"
#include "expect.h"
#include "observe/array_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    // A right checksum behind the bytes, so that what lies beyond that check is reached too.
    std::string bytes(fuzz::text_of(data, size));
    const std::uint32_t sum = tumble::crc32(bytes);
    for (int shift = 0; shift < 32; shift += 8)
        bytes += static_cast<char>(sum >> shift & 0xff);
    for (const std::string kind : {"frame", "layout"})
        if (const auto content = tumble::observe::from_bytes(bytes, kind, "frame.tumble"); !content)
            fuzz::expect_helpful(content.problems());
    return 0;
}
