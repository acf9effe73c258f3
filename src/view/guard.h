#pragma once

#include <cstdint>
#include <string>
#include <string_view>

/// Who may see the view. Loopback alone does not keep others out: any page in the same browser can send requests to
/// 127.0.0.1, and a name that its owner points there (DNS rebinding) even reads the answers.
namespace tumble::view {

/// What a request says of itself; empty where it says nothing.
struct Asked {
    std::string method;
    std::string target; // path and query
    std::string host;
    std::string origin;
    std::string cookie;
    bool upgrade = false; // to a WebSocket
    bool body = false;    // it brings one
};

struct Answer {
    int status = 200;        // of HTTP; 101: go on as a WebSocket
    std::string file;        // of the page, for 200
    std::string set_cookie;  // empty: none
    std::string explanation; // for other statuses, a sentence
};

/// An answer that lets nobody in, with the reason as a sentence.
Answer refusal(int status, std::string explanation);

/// Lets in whoever brings the token of the link, which is good for one browser and then replaced, and later its cookie.
class Guard {
public:
    explicit Guard(int port);

    /// Refuses with 400, 403, 404, 405 or 426; the first reason of these in the order of the code.
    Answer judge(const Asked& asked);

    /// For the next browser.
    [[nodiscard]] std::string link() const;
    /// How many browsers a link has let in.
    [[nodiscard]] int admitted() const { return admitted_; }

private:
    [[nodiscard]] bool is_ours(std::string_view host) const;
    [[nodiscard]] bool has_cookie(std::string_view cookies) const;
    Answer admit(std::string_view token);

    int port_ = 0;
    int admitted_ = 0;
    std::string token_;
    std::string secret_; // the cookie's value
};

/// 128 bits of the system's randomness as 32 hexadecimal digits.
std::string random_token();

/// Takes as long whichever bytes differ.
bool equal_in_constant_time(std::string_view a, std::string_view b);

} // namespace tumble::view
