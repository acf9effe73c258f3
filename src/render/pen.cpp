#include "render/pen.h"

#include <algorithm>

namespace tumble::render {

/// A letter may take several bytes; those after the first begin with the bits 10.
static bool begins_letter(char byte) {
    return (static_cast<unsigned char>(byte) & 0xc0) != 0x80;
}

std::string Pen::shortened(const std::string& text, Lettering lettering, double room) const {
    if (width(text, lettering) <= room) {
        return text;
    }
    std::string part = text;
    while (!part.empty()) {
        while (!begins_letter(part.back()) && part.size() > 1) {
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

std::string Pen::shortened_inside(const std::string& text, Lettering lettering, double room) const {
    if (width(text, lettering) <= room) {
        return text;
    }
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (begins_letter(text[i])) {
            starts.push_back(i);
        }
    }
    for (std::size_t kept = starts.size() - 1; kept >= 2; --kept) {
        const std::string cut =
            text.substr(0, starts[kept / 2]) + "..." + text.substr(starts[starts.size() - (kept - kept / 2)]);
        if (width(cut, lettering) <= room) {
            return cut;
        }
    }
    return {};
}

std::string Pen::entire(const std::string& text, Lettering lettering, double room) {
    const double needed = width(text, lettering);
    if (needed > room) {
        note_crowded(text, std::max(room, 0.0) / needed);
    }
    return shortened(text, lettering, room);
}

} // namespace tumble::render
