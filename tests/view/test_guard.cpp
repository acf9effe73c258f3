#include "view/guard.h"

#include <doctest/doctest.h>
#include <set>

using namespace tumble::view;

namespace test_guard {

constexpr int port = 4711;
const std::string host = "127.0.0.1:4711";

Asked get(const std::string& target) {
    return {.method = "GET", .target = target, .host = host, .origin = {}, .cookie = {}};
}

std::string target_of(const std::string& link) {
    return link.substr(link.find('/', 8));
}

/// "tumble_4711=..." of what Set-Cookie says.
std::string cookie_of(const Answer& answer) {
    return answer.set_cookie.substr(0, answer.set_cookie.find(';'));
}

TEST_CASE("the link lets one browser in, for a cookie that no script reads and no other page's request carries") {
    Guard guard(port);
    const std::string link = guard.link();
    CHECK(link.starts_with("http://127.0.0.1:4711/?token="));
    CHECK(link.size() == std::string("http://127.0.0.1:4711/?token=").size() + 32); // 128 bits, hexadecimal
    const Answer first = guard.judge(get(target_of(link)));
    CHECK(first.status == 200);
    CHECK(first.file == "/");
    CHECK(first.set_cookie.find("; HttpOnly; SameSite=Strict; Path=/") != std::string::npos);
    CHECK(guard.judge(get(target_of(link))).status == 403); // once
    CHECK(guard.link() != link);
    CHECK(guard.judge(get(target_of(guard.link()))).status == 200); // another browser with the next
    Asked again = get("/");
    again.cookie = "other=1; " + cookie_of(first);
    CHECK(guard.judge(again).status == 200);
    again.target = "/view.js";
    CHECK(guard.judge(again).status == 200);
}

TEST_CASE("on HTTP's own port browsers name the host alone, and on no other port may they") {
    Guard usual(80), other(port);
    for (const char* name : {"127.0.0.1", "localhost", "127.0.0.1:80"}) {
        Asked asked{.method = "GET", .target = target_of(usual.link()), .host = name, .origin = {}, .cookie = {}};
        const Answer first = usual.judge(asked);
        CHECK_MESSAGE(first.status == 200, name);
        asked = {.method = "GET", .target = "/frames", .host = name, .origin = {}, .cookie = cookie_of(first)};
        asked.origin = "http://" + asked.host;
        asked.upgrade = true;
        CHECK_MESSAGE(usual.judge(asked).status == 101, name);
        asked.origin = "http://127.0.0.1:8080";
        CHECK_MESSAGE(usual.judge(asked).status == 403, name);
        asked = get(target_of(other.link()));
        asked.host = name;
        CHECK_MESSAGE(other.judge(asked).status == 403, name);
    }
}

TEST_CASE("a browser that has been let in may open its used link again, and uses up no other") {
    Guard guard(port);
    Asked asked = get(target_of(guard.link()));
    asked.cookie = cookie_of(guard.judge(asked));
    const std::string next = guard.link();
    for (const std::string& link : {asked.target, target_of(next)}) {
        asked.target = link;
        const Answer answer = guard.judge(asked);
        CHECK(answer.status == 200);
        CHECK(answer.file == "/");
        CHECK(answer.set_cookie.empty());
    }
    CHECK(guard.link() == next);
    CHECK(guard.admitted() == 1);
    asked.cookie.back() = asked.cookie.back() == '0' ? '1' : '0';
    asked.target = "/?token=" + std::string(32, '0');
    CHECK(guard.judge(asked).status == 403);
}

TEST_CASE("without the token or with a wrong one nothing is told, not even whether a file exists") {
    Guard guard(port);
    const std::string token = guard.link().substr(guard.link().find('=') + 1);
    for (const std::string& target :
         {std::string("/"), std::string("/view.js"), std::string("/frames"), std::string("/nothing"),
          "/?token=" + token.substr(1), "/?token=" + token + "0", std::string("/?token="), "/view.js?token=" + token})
        CHECK_MESSAGE(guard.judge(get(target)).status == 403, target);
    Asked guess = get("/");
    guess.cookie = "tumble_4711=" + token; // the token is not the cookie
    CHECK(guard.judge(guess).status == 403);
}

TEST_CASE("a host that is not ours (DNS rebinding) and an origin that is not ours are refused even with the cookie") {
    Guard guard(port);
    const std::string cookie = cookie_of(guard.judge(get(target_of(guard.link()))));
    const auto status = [&](Asked asked) {
        asked.cookie = cookie;
        return guard.judge(asked).status;
    };
    Asked asked = get("/");
    CHECK(status(asked) == 200);
    asked.host = "localhost:4711";
    CHECK(status(asked) == 200);
    for (const char* other :
         {"evil.example:4711", "127.0.0.1", "127.0.0.1:80", "localhost.evil.example:4711", "[::1]:4711"}) {
        asked.host = other;
        CHECK_MESSAGE(status(asked) == 403, other);
    }
    asked.host = "";
    CHECK(status(asked) == 400);
    asked.host = host;
    for (const char* other : {"http://evil.example", "https://127.0.0.1:4711", "null", "http://127.0.0.1:4712"}) {
        asked.origin = other;
        CHECK_MESSAGE(status(asked) == 403, other);
    }
    asked.origin = "http://127.0.0.1:4711";
    CHECK(status(asked) == 200);
}

TEST_CASE("frames go only to an upgrade that says it comes from our own page") {
    Guard guard(port);
    Asked asked = get("/frames");
    asked.cookie = cookie_of(guard.judge(get(target_of(guard.link()))));
    CHECK(guard.judge(asked).status == 426);
    asked.upgrade = true;
    CHECK(guard.judge(asked).status == 403); // no origin
    asked.origin = "http://evil.example";
    CHECK(guard.judge(asked).status == 403);
    asked.origin = "http://127.0.0.1:4711";
    CHECK(guard.judge(asked).status == 101);
    asked.target = "/";
    CHECK(guard.judge(asked).status == 400);
    asked.target = "/frames";
    asked.cookie.back() = asked.cookie.back() == '0' ? '1' : '0';
    CHECK(guard.judge(asked).status == 403);
}

TEST_CASE("other methods, bodies, strange targets and files that there are none of") {
    Guard guard(port);
    const std::string cookie = cookie_of(guard.judge(get(target_of(guard.link()))));
    Asked asked = get("/");
    asked.cookie = cookie;
    asked.method = "POST";
    CHECK(guard.judge(asked).status == 405);
    asked.method = "GET";
    asked.body = true;
    CHECK(guard.judge(asked).status == 400);
    asked.body = false;
    for (const std::string& target : {std::string(""), std::string("*"), std::string("http://127.0.0.1:4711/"),
                                      std::string("/a b"), "/" + std::string(300, 'a')}) {
        asked.target = target;
        CHECK_MESSAGE(guard.judge(asked).status == 400, target);
    }
    for (const char* target : {"/etc/passwd", "/../guard.cpp", "/..%2fguard.cpp", "//view.js"}) {
        asked.target = target;
        CHECK_MESSAGE(guard.judge(asked).status == 404, target);
    }
}

TEST_CASE("tokens are 32 hexadecimal digits and never the same") {
    std::set<std::string> seen;
    for (int i = 0; i < 1000; ++i) {
        const std::string token = random_token();
        CHECK(token.size() == 32);
        CHECK(token.find_first_not_of("0123456789abcdef") == std::string::npos);
        seen.insert(token);
    }
    CHECK(seen.size() == 1000);
    CHECK(equal_in_constant_time("abc", "abc"));
    CHECK(!equal_in_constant_time("abc", "abd"));
    CHECK(!equal_in_constant_time("abc", "abcd"));
}

} // namespace test_guard
