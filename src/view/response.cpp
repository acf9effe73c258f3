#include "view/response.h"

#include "view/page.h"

#include <fmt/format.h>

namespace tumble::view {

namespace {

std::string policy_for(int port) {
    return fmt::format("default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; connect-src 'self' "
                       "ws://127.0.0.1:{0} ws://localhost:{0}; base-uri 'none'; form-action 'none'; "
                       "frame-ancestors 'none'",
                       port);
}

void set_policies(Response& response, int port) {
    response.set("Content-Security-Policy", policy_for(port));
    response.set("X-Content-Type-Options", "nosniff");
    response.set("X-Frame-Options", "DENY");
    response.set("Cross-Origin-Opener-Policy", "same-origin");
    response.set("Cross-Origin-Resource-Policy", "same-origin");
    response.set("Referrer-Policy", "no-referrer");
    response.set(http::field::cache_control, "no-store");
}

} // namespace

Response response_of(const Answer& answer, int port, bool keep_alive) {
    Response response(static_cast<http::status>(answer.status), 11);
    const PageFile* file = answer.status == 200 ? find_page_file(answer.file) : nullptr;
    const std::string_view type = file ? file->type : "text/plain; charset=utf-8";
    response.set(http::field::content_type, {type.data(), type.size()});
    set_policies(response, port);
    if (!answer.set_cookie.empty())
        response.set(http::field::set_cookie, answer.set_cookie);
    response.body() = file ? std::string(file->content) : answer.explanation + "\n";
    response.keep_alive(keep_alive);
    response.prepare_payload();
    return response;
}

} // namespace tumble::view
