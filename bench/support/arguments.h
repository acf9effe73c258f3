#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace tumble::bench {

/// A bench program's command line, "name=value ..."; whoever reads a name that was not given gets the fallback. A wrong
/// value or, in finish(), a name that nobody read ends the program with a sentence and exit code 2.
class Arguments {
public:
    Arguments(int count, char** words);

    double number(const std::string& name, double fallback);
    std::int64_t whole(const std::string& name, std::int64_t fallback);
    std::string text(const std::string& name, const std::string& fallback);
    /// Numbers between commas, empty when not given.
    std::vector<double> numbers(const std::string& name);
    /// Words between commas, empty when not given.
    std::vector<std::string> words(const std::string& name);
    void finish() const;

private:
    std::map<std::string, std::string> given_;
    std::set<std::string> read_;
};

/// Says what is wrong on stderr and ends the program with exit code 2.
[[noreturn]] void refuse(const std::string& what);

} // namespace tumble::bench
