#pragma once

#include "view/beast.h"
#include "view/guard.h"

namespace tumble::view {

using Response = http::response<http::string_body>;

/// The response that carries an answer of the server on that port: a file of the page for 200, else the answer's
/// sentence; with the heads that keep other pages from reading it and ours from running any script but its own.
Response response_of(const Answer& answer, int port, bool keep_alive);

} // namespace tumble::view
