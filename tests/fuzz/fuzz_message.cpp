#include "expect.h"
#include "view/message.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto message = tumble::view::parse_message(fuzz::text_of(data, size));
    if (!message)
        return 0;
    // What was read once is written and read again as the same message, in no more than a WebSocket message may take.
    const std::string written = tumble::view::to_text(*message);
    fuzz::expect(written.size() <= 256, "a message is short");
    fuzz::expect(tumble::view::parse_message(written) == message, "same message again");
    return 0;
}
