#include "view/guard.h"

#include "base/text.h"
#include "view/page.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <random>

namespace tumble::view {

namespace {

constexpr std::size_t longest_target = 256;
constexpr int usual_port = 80; // of HTTP

bool is_plain_target(std::string_view target) {
    return target.starts_with('/') && target.size() <= longest_target &&
           std::all_of(target.begin(), target.end(), [](unsigned char c) { return c > 0x20 && c < 0x7f; });
}

} // namespace

Answer refusal(int status, std::string explanation) {
    return {.status = status, .file = {}, .set_cookie = {}, .explanation = std::move(explanation)};
}

std::string random_token() {
    std::random_device system; // libstdc++: getrandom or the processor's own, never a seeded generator
    std::string token;
    for (int k = 0; k < 4; ++k)
        token += fmt::format("{:08x}", static_cast<std::uint32_t>(system()));
    return token;
}

bool equal_in_constant_time(std::string_view a, std::string_view b) {
    if (a.size() != b.size())
        return false;
    unsigned differ = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        differ |= static_cast<unsigned>(static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]));
    return differ == 0;
}

Guard::Guard(int port) : port_(port), token_(random_token()), secret_(random_token()) {}

std::string Guard::link() const {
    return fmt::format("http://127.0.0.1:{}/?token={}", port_, token_);
}

/// Browsers leave the port away where it is HTTP's own.
bool Guard::is_ours(std::string_view host) const {
    if (port_ == usual_port && (host == "127.0.0.1" || host == "localhost"))
        return true;
    return host == fmt::format("127.0.0.1:{}", port_) || host == fmt::format("localhost:{}", port_);
}

/// A browser sends the cookies of all ports of a host: the port in the name keeps two views apart.
bool Guard::has_cookie(std::string_view cookies) const {
    const std::string name = fmt::format("tumble_{}=", port_);
    for (const std::string_view part : split(cookies, ';')) {
        const std::string_view cookie = trimmed(part);
        if (cookie.starts_with(name) && equal_in_constant_time(cookie.substr(name.size()), secret_))
            return true;
    }
    return false;
}

/// The page comes with the cookie: a redirect that began at a link in another page would not carry a strict cookie.
Answer Guard::admit(std::string_view token) {
    if (!equal_in_constant_time(token, token_))
        return refusal(403, "this link has been used, or was never right: take the newest that the program printed");
    token_ = random_token();
    ++admitted_;
    Answer answer{.status = 200, .file = "/", .set_cookie = {}, .explanation = {}};
    answer.set_cookie = fmt::format("tumble_{}={}; HttpOnly; SameSite=Strict; Path=/", port_, secret_);
    return answer;
}

Answer Guard::judge(const Asked& asked) {
    if (asked.method != "GET")
        return refusal(405, "only GET is answered here");
    if (asked.host.empty() || !is_plain_target(asked.target) || asked.body)
        return refusal(400, "this request is not one that a browser would send");
    if (!is_ours(asked.host))
        return refusal(403, "this address is not the one that the program printed");
    const bool origin_is_ours = asked.origin.starts_with("http://") && is_ours(asked.origin.substr(7));
    if (!asked.origin.empty() && !origin_is_ours)
        return refusal(403, "other pages have no say here");
    const std::string_view target = asked.target;
    const std::string_view path = target.substr(0, target.find('?'));
    constexpr std::string_view with_token = "/?token=";
    const bool is_known = has_cookie(asked.cookie); // opens a used link again: the page, and no token is used up
    if (!asked.upgrade && target.starts_with(with_token) && !is_known)
        return admit(target.substr(with_token.size()));
    if (!is_known)
        return refusal(403, "open the link that the program printed");
    if (path == socket_path) {
        if (!asked.upgrade)
            return refusal(426, "this is the way of frames, not a page");
        if (!origin_is_ours)
            return refusal(403, "a page has to say where it comes from");
        return {.status = 101, .file = {}, .set_cookie = {}, .explanation = {}};
    }
    if (asked.upgrade)
        return refusal(400, "frames do not come from there");
    if (!find_page_file(path))
        return refusal(404, "there is no such file");
    return {.status = 200, .file = std::string(path), .set_cookie = {}, .explanation = {}};
}

} // namespace tumble::view
