#include "render/pen.h"

namespace tumble::render {

std::string Pen::shortened(const std::string& text, Lettering lettering, double room) const {
    if (width(text, lettering) <= room) {
        return text;
    }
    std::string part = text;
    while (!part.empty()) {
        // A letter may take several bytes; those after the first begin with the bits 10.
        while ((static_cast<unsigned char>(part.back()) & 0xc0) == 0x80 && part.size() > 1) {
            part.pop_back();
        }
        part.pop_back();
        while (!part.empty() && part.back() == ' ') {
            part.pop_back();
        }
        if (width(part + "...", lettering) <= room) {
            return part + "...";
        }
    }
    return {};
}

} // namespace tumble::render
