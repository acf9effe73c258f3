#pragma once

#include "view/beast.h"
#include "view/guard.h"
#include "view/limits.h"

#include <optional>

/// From the bytes of a connection to what it is answered, without the connection.
namespace tumble::view {

using Request = http::request<http::string_body>;
using RequestParser = http::request_parser<http::string_body>;

/// Lets the parser read no more than one request may bring. It is to read the head alone: whoever brings a body is
/// refused, and none is read.
void set_limits(RequestParser& parser, const Limits& limits);

/// The answer to a request whose reading ended with `failed`: 400, 413 and 431 where it is none or too large, else what
/// the guard says. Nothing: the connection ended or was silent, and nobody waits for a word.
std::optional<Answer> answer_to(const RequestParser& parser, error_code failed, Guard& guard, const Limits& limits);

} // namespace tumble::view
