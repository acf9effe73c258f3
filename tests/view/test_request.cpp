#include "view/request.h"
#include "view/response.h"

#include <boost/asio/io_context.hpp>
#include <boost/beast/_experimental/test/stream.hpp>
#include <doctest/doctest.h>

using namespace tumble::view;

namespace test_request {

constexpr int port = 4321;
const std::string host = "Host: 127.0.0.1:4321\r\n";

/// What is answered to bytes that come `piece` at a time over a connection that then ends; 0: nothing.
int answer(const std::string& bytes, std::size_t piece, Guard& guard) {
    asio::io_context loop;
    boost::beast::test::stream connection(loop);
    connection.append(bytes);
    connection.close_remote();
    connection.read_size(piece);
    RequestParser parser;
    set_limits(parser, {});
    boost::beast::flat_buffer buffer;
    error_code failed;
    http::read_header(connection, buffer, parser, failed);
    const auto answer = answer_to(parser, failed, guard, {});
    return answer ? answer->status : 0;
}

std::string cookie_line(Guard& guard) {
    const std::string link = guard.link();
    const std::string cookie = guard.judge({"GET", link.substr(link.find("/?")), "127.0.0.1:4321", "", ""}).set_cookie;
    return "Cookie: " + cookie.substr(0, cookie.find(';')) + "\r\n";
}

TEST_CASE("a request is answered alike in whatever pieces it comes, and one that is not whole not at all") {
    Guard guard(port);
    const std::string cookie = cookie_line(guard), get = "GET / HTTP/1.1\r\n";
    const std::string upgrade = "GET /frames HTTP/1.1\r\n" + host + cookie +
                                "Origin: http://127.0.0.1:4321\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
                                "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n";
    for (const auto& [bytes, status] : std::vector<std::pair<std::string, int>>{
             {get + host + cookie + "\r\n", 200},
             {upgrade, 101},
             {get + host + "\r\n", 403},
             {get + cookie + "\r\n", 400},
             {"GET / HTTP/7\r\n\r\n", 400},
             {get + "no colon\r\n\r\n", 400},
             {std::string("\0\x16\x03\x01", 4) + "\r\n\r\n", 400}, // as TLS begins
             {get + host + cookie + "Content-Length: 1\r\n\r\nx", 400},
             {get + host + cookie + "Content-Length: 1025\r\n\r\n", 413},
             {get + host + cookie + "Transfer-Encoding: chunked\r\n\r\n1000\r\n" + std::string(4096, 'x') + "\r\n",
              400},
             {get + host + "X: " + std::string(9000, 'x') + "\r\n\r\n", 431},
             {"", 0},
             {get + host + cookie, 0},
             {get + host + cookie + "Content-Length: 5\r\n\r\nxx", 400}})
        for (const std::size_t piece : {1, 7, 100, 100000}) {
            CAPTURE(bytes);
            CAPTURE(piece);
            CHECK(answer(bytes, piece, guard) == status);
        }
}

TEST_CASE("a refusal is its sentence under the page's policies, which name the server's own port and no other") {
    const Response response = response_of(refusal(403, "other pages have no say here"), port, false);
    CHECK(response.result_int() == 403);
    CHECK(response.body() == "other pages have no say here\n");
    CHECK(response[http::field::content_type] == "text/plain; charset=utf-8");
    CHECK(response[http::field::set_cookie].empty());
    CHECK(!response.keep_alive());
    const std::string policy(response["Content-Security-Policy"]);
    CHECK(policy.find("default-src 'none'; script-src 'self';") == 0);
    CHECK(policy.find("connect-src 'self' ws://127.0.0.1:4321 ws://localhost:4321;") != std::string::npos);
}

} // namespace test_request
