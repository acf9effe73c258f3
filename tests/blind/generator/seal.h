#pragma once

#include <string>

namespace blind {

/// SHA-256 of the bytes, 64 hexadecimal digits (OpenSSL).
std::string sha256(const std::string& bytes);

} // namespace blind
