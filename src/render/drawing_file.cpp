#include "render/drawing_file.h"

#include "base/ending.h"
#include "render/file_swap.h"

#include <cstdint>

namespace tumble::render {

bool is_drawing_file(const std::filesystem::path& file) {
    return ending_of(file) == ".svg" || ending_of(file) == ".pdf";
}

Result<Done> write_drawing(const Drawing& drawing, const std::filesystem::path& file) {
    const std::string bytes = ending_of(file) == ".pdf" ? encode_pdf(drawing) : encode_svg(drawing);
    return write_file(file, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

} // namespace tumble::render
