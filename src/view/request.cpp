#include "view/request.h"

namespace tumble::view {

namespace {

std::string text_of(beast::string_view text) {
    return {text.data(), text.size()};
}

/// Whether what came is no HTTP, and not only less than a whole request.
bool is_malformed(error_code failed) {
    return failed.category() == http::make_error_code(http::error::bad_method).category() &&
           failed != http::error::end_of_stream && failed != http::error::partial_message;
}

/// Bytes, as browsers write it: Beast counts the first line apart from the others.
std::size_t size_of_head(const Request& request) {
    constexpr std::size_t first = 2 + 8 + 2, line = 2 + 2, last = 2; // blanks, "HTTP/1.1", colons, ends of lines
    std::size_t bytes = request.method_string().size() + request.target().size() + first + last;
    for (const auto& field : request)
        bytes += field.name_string().size() + field.value().size() + line;
    return bytes;
}

Asked asked_by(const RequestParser& parser) {
    const Request& request = parser.get();
    return {text_of(request.method_string()),
            text_of(request.target()),
            text_of(request[http::field::host]),
            text_of(request[http::field::origin]),
            text_of(request[http::field::cookie]),
            websocket::is_upgrade(request),
            !parser.is_done()};
}

} // namespace

void set_limits(RequestParser& parser, const Limits& limits) {
    parser.header_limit(static_cast<std::uint32_t>(limits.header_bytes));
    parser.body_limit(limits.body_bytes);
}

std::optional<Answer> answer_to(const RequestParser& parser, error_code failed, Guard& guard, const Limits& limits) {
    if (failed == http::error::body_limit)
        return refusal(413, "a request that brings so much is not read");
    if (failed == http::error::header_limit || (!failed && size_of_head(parser.get()) > limits.header_bytes))
        return refusal(431, "a request with so long a head is not read");
    if (is_malformed(failed))
        return refusal(400, "this is not HTTP");
    if (failed)
        return std::nullopt;
    return guard.judge(asked_by(parser));
}

} // namespace tumble::view
