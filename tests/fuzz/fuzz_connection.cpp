#include "expect.h"
#include "view/grip.h"
#include "view/page.h"
#include "view/request.h"
#include "view/response.h"

#include <boost/asio/io_context.hpp>
#include <boost/beast/_experimental/test/stream.hpp>
#include <set>

// All that may come over one connection to the view's server: requests one after the other, and WebSocket frames behind
// one that asks for them; read as src/view/visitor.cpp and watcher.cpp do, from memory. The first byte says how many
// bytes come at a time. TOKEN and COOKIE stand for what nobody can guess.
namespace {

using namespace tumble::view;
using Connection = boost::beast::test::stream;

constexpr int port = 8080;

/// The bytes with each `word` replaced, and whether there was one.
bool fill(std::string& bytes, const std::string& word, const std::string& with) {
    bool found = false;
    for (auto at = bytes.find(word); at != std::string::npos; at = bytes.find(word, at + with.size())) {
        bytes.replace(at, word.size(), with);
        found = true;
    }
    return found;
}

bool names_us(const std::string& bytes, const std::string& before) {
    return bytes.find(before + "127.0.0.1:8080") != std::string::npos ||
           bytes.find(before + "localhost:8080") != std::string::npos;
}

/// What is held down by the messages of one browser.
struct Held {
    std::set<int> buttons;
    std::set<std::string> keys;

    void take(const Message& message) {
        if (const auto* pressed = std::get_if<PointerPressed>(&message))
            buttons.insert(pressed->button);
        else if (const auto* released = std::get_if<PointerReleased>(&message))
            buttons.erase(released->button);
        else if (const auto* key = std::get_if<KeyChanged>(&message)) {
            if (key->down)
                keys.insert(key->key);
            else
                keys.erase(key->key);
        }
    }
};

void watch(Connection& connection, const Request& request, const Limits& limits) {
    websocket::stream<Connection&> socket(connection);
    socket.read_message_max(limits.message_bytes);
    error_code failed;
    socket.accept(request, failed);
    Grip grip;
    Held held;
    while (!failed) {
        beast::flat_buffer buffer;
        socket.read(buffer, failed);
        if (failed || !socket.got_text())
            break;
        const std::string text = beast::buffers_to_string(buffer.data());
        fuzz::expect(text.size() <= limits.message_bytes, "no message is longer than allowed");
        const auto message = parse_message(text);
        if (!message || !grip.note(*message))
            break;
        held.take(*message);
    }
    for (const Message& message : grip.let_go())
        held.take(message);
    fuzz::expect(held.buttons.empty() && held.keys.empty(), "nothing stays held when a browser has gone");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0)
        return 0;
    Guard guard(port);
    const auto token = [&] { return guard.link().substr(guard.link().find('=') + 1); };
    const std::string cookie = guard.judge({"GET", "/?token=" + token(), "localhost:8080", "", ""}).set_cookie;
    std::string bytes(fuzz::text_of(data + 1, size - 1));
    const bool has_token = fill(bytes, "TOKEN", token());
    const bool has_cookie = fill(bytes, "COOKIE", cookie.substr(0, cookie.find(';')));

    static asio::io_context loop;
    const Limits limits;
    Connection connection(loop), browser(loop);
    connection.connect(browser);
    connection.append(bytes);
    connection.close_remote();
    connection.read_size(1U + data[0]);
    beast::flat_buffer buffer;
    for (bool goes_on = true; goes_on;) {
        RequestParser parser;
        set_limits(parser, limits);
        error_code failed;
        http::read_header(connection, buffer, parser, failed);
        const std::optional<Answer> answer = answer_to(parser, failed, guard, limits);
        if (!answer)
            break;
        static const std::set<int> known{101, 200, 400, 403, 404, 405, 413, 426, 431};
        fuzz::expect(known.contains(answer->status), "a status that docs and tests know");
        const bool let_in = answer->status == 101 || answer->status == 200;
        fuzz::expect(!let_in || has_token || has_cookie, "nobody comes in without the token or the cookie");
        fuzz::expect(!let_in || names_us(bytes, ""), "nobody comes in who does not name this server");
        fuzz::expect(let_in || !answer->explanation.empty(), "a refusal has a sentence");
        if (answer->status == 101) {
            fuzz::expect(has_cookie, "frames are for who brings the cookie");
            fuzz::expect(names_us(bytes, "http://"), "frames are for our own page");
            const std::string rest = beast::buffers_to_string(buffer.data()) + std::string(connection.str());
            connection.clear();
            connection.append(rest);
            watch(connection, parser.release(), limits);
            break;
        }
        const Response response = response_of(*answer, port, let_in);
        fuzz::expect(!response.body().empty() && !response["Content-Security-Policy"].empty(), "an answer is whole");
        fuzz::expect(response["Access-Control-Allow-Origin"].empty(), "other pages read nothing");
        goes_on = let_in && parser.get().keep_alive();
    }
    fuzz::expect(guard.admitted() <= 2, "a token lets one browser in");
    return 0;
}
