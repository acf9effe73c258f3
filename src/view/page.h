#pragma once

#include <string_view>

/// The page that shows the view; src/view/page, compiled into the program.
namespace tumble::view {

struct PageFile {
    std::string_view path; // of the request
    std::string_view type; // for Content-Type
    std::string_view content;
};

inline constexpr std::string_view socket_path = "/frames";

/// Null where there is no file of that path.
const PageFile* find_page_file(std::string_view path);

} // namespace tumble::view
