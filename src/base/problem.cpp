#include "base/problem.h"

namespace tumble {

std::string to_string(const Problem& problem) {
    std::string text;
    if (!problem.file.empty()) {
        text += problem.file;
        if (problem.line > 0)
            text += ":" + std::to_string(problem.line);
        if (problem.line > 0 && problem.column > 0)
            text += ":" + std::to_string(problem.column);
        text += ": ";
    }
    text += problem.what;
    if (!problem.fix.empty())
        text += "\n    " + problem.fix;
    return text;
}

std::string to_string(const Problems& problems) {
    std::string text;
    for (const Problem& problem : problems)
        text += to_string(problem) + "\n";
    return text;
}

} // namespace tumble
