#include "scene/lines.h"

#include <algorithm>

namespace tumble::scene {
namespace {

constexpr std::string_view blanks = " \t\r\f\v";

Field stripped(std::string_view line, std::size_t begin, std::size_t end) {
    while (begin < end && blanks.find(line[begin]) != std::string_view::npos)
        ++begin;
    while (end > begin && blanks.find(line[end - 1]) != std::string_view::npos)
        --end;
    return {line.substr(begin, end - begin), static_cast<int>(begin) + 1};
}

} // namespace

bool Lines::next(Line& line) {
    if (at_ >= text_.size())
        return false;
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    line.text = text_.substr(at_, end - at_);
    if (!line.text.empty() && line.text.back() == '\r')
        line.text.remove_suffix(1);
    line.number = ++number_;
    at_ = end + 1;
    return true;
}

std::string_view without_comment(std::string_view line) {
    return line.substr(0, line.find('#'));
}

std::vector<Field> comma_fields(std::string_view line) {
    std::vector<Field> fields;
    std::size_t begin = 0;
    while (true) {
        const std::size_t comma = line.find(',', begin);
        fields.push_back(stripped(line, begin, std::min(comma, line.size())));
        if (comma == std::string_view::npos)
            return fields;
        begin = comma + 1;
    }
}

std::vector<Field> blank_fields(std::string_view line) {
    std::vector<Field> fields;
    std::size_t begin = line.find_first_not_of(blanks);
    while (begin != std::string_view::npos) {
        const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
        fields.push_back({line.substr(begin, end - begin), static_cast<int>(begin) + 1});
        begin = line.find_first_not_of(blanks, end);
    }
    return fields;
}

} // namespace tumble::scene
