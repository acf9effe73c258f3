#pragma once

#include <arpa/inet.h>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <doctest/doctest.h>
#include <netinet/in.h>
#include <optional>
#include <string>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

/// A client that says exactly what it is told to, well-formed or not: bytes over TCP, and WebSocket frames of RFC 6455.
namespace tumble::view::testing {

class Client {
public:
    explicit Client(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
        sockaddr_in place{};
        place.sin_family = AF_INET;
        place.sin_port = htons(static_cast<std::uint16_t>(port));
        place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        const timeval limit{60, 0}; // only so that a broken server fails instead of hanging
        ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
        REQUIRE(::connect(socket_, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0);
    }
    Client(const Client&) = delete;
    Client& operator=(const Client&) = delete;
    ~Client() { ::close(socket_); }

    void send(const std::string& bytes) const {
        std::size_t done = 0;
        while (done < bytes.size()) {
            const auto sent = ::send(socket_, bytes.data() + done, bytes.size() - done, MSG_NOSIGNAL);
            if (sent <= 0)
                return; // the other side has closed: what it said is read next
            done += static_cast<std::size_t>(sent);
        }
    }

    /// Whether the other side closed, after whatever else it said.
    bool is_closed() {
        while (more()) {
        }
        return closed_;
    }

    /// The head of the next answer, and what its Content-Length says in body().
    std::string head() {
        std::size_t end = 0;
        while ((end = read_.find("\r\n\r\n")) == std::string::npos)
            if (!more())
                return "";
        std::string head = read_.substr(0, end + 2);
        read_.erase(0, end + 4);
        const std::string name = "Content-Length: ";
        const auto at = head.find(name);
        const std::size_t length = at == std::string::npos ? 0 : std::stoul(head.substr(at + name.size()));
        while (read_.size() < length && more()) {
        }
        body_ = read_.substr(0, length);
        read_.erase(0, length);
        return head;
    }
    [[nodiscard]] const std::string& body() const { return body_; }

    /// 200 of "HTTP/1.1 200 OK"; 0 when there was no answer.
    int status() {
        const std::string head = this->head();
        return head.size() > 12 ? std::stoi(head.substr(9, 3)) : 0;
    }

    /// A text message with the mask that clients must set.
    void say(const std::string& text) const {
        std::string frame{static_cast<char>(0x81)};
        if (text.size() < 126)
            frame += static_cast<char>(0x80 | text.size());
        else {
            frame += static_cast<char>(0x80 | 126);
            frame += static_cast<char>(text.size() >> 8);
            frame += static_cast<char>(text.size() & 0xff);
        }
        const std::string mask = "\x01\x02\x03\x04";
        frame += mask;
        for (std::size_t i = 0; i < text.size(); ++i)
            frame += static_cast<char>(text[i] ^ mask[i % 4]);
        send(frame);
    }

    struct Heard {
        int opcode = 0; // 2: binary, 8: close
        std::string payload;
    };
    /// The next message, however many frames it comes in; nothing when the connection ended.
    std::optional<Heard> hear() {
        std::optional<Heard> all;
        while (!all || !last_) {
            std::optional<Heard> part = frame();
            if (!part)
                return std::nullopt;
            if (!all)
                all = std::move(part);
            else
                all->payload += part->payload;
        }
        return all;
    }

private:
    std::optional<Heard> frame() {
        if (!have(2))
            return std::nullopt;
        const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(read_[i]); };
        std::uint64_t length = byte(1) & 0x7f;
        std::size_t head = 2;
        if (length >= 126) {
            const std::size_t digits = length == 126 ? 2 : 8;
            if (!have(2 + digits))
                return std::nullopt;
            length = 0;
            for (std::size_t i = 0; i < digits; ++i)
                length = length << 8 | byte(2 + i);
            head += digits;
        }
        if (!have(head + length))
            return std::nullopt;
        last_ = (byte(0) & 0x80) != 0;
        Heard heard{byte(0) & 0x0f, read_.substr(head, length)};
        read_.erase(0, head + length);
        return heard;
    }

    bool have(std::size_t bytes) {
        while (read_.size() < bytes)
            if (!more())
                return false;
        return true;
    }
    bool more() {
        char part[65536];
        const auto got = ::recv(socket_, part, sizeof part, 0);
        closed_ = got == 0 || (got < 0 && errno == ECONNRESET);
        if (got <= 0)
            return false;
        read_.append(part, static_cast<std::size_t>(got));
        return true;
    }

    int socket_;
    bool closed_ = false;
    bool last_ = false; // frame of a message
    std::string read_;
    std::string body_;
};

/// A request of a browser on this machine for a path, with further lines of its head.
inline std::string request(int port, const std::string& path, const std::string& more = "") {
    return "GET " + path + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) + "\r\n" + more + "\r\n";
}

inline std::string upgrade(int port, const std::string& cookie, const std::string& origin) {
    return request(port, "/frames",
                   "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                   "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nCookie: " +
                       cookie + "\r\nOrigin: " + origin + "\r\n");
}

/// Path and query of a link.
inline std::string target_of(const std::string& link) {
    return link.substr(link.find('/', 8));
}

/// Takes the link's token for its cookie, "name=value".
inline std::string cookie_for(int port, const std::string& link) {
    Client client(port);
    client.send(request(port, target_of(link)));
    const std::string head = client.head();
    const std::string name = "Set-Cookie: ";
    const auto at = head.find(name);
    REQUIRE(at != std::string::npos);
    return head.substr(at + name.size(), head.find(';', at) - at - name.size());
}

} // namespace tumble::view::testing
