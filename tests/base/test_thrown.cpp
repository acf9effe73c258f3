#include "base/thrown.h"

#include <doctest/doctest.h>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace test_thrown {

using namespace tumble;

namespace {

template <class Work> Problem problem_in(Work&& work) {
    try {
        work();
    } catch (const std::exception& thrown) {
        return problem_of(thrown);
    }
    return {};
}

} // namespace

TEST_CASE("memory that ran out is said in words, whether the system or the library refuses it") {
    for (const Problem& problem : {problem_in([] { throw std::bad_alloc(); }), problem_in([] {
                                       std::vector<double>().reserve(std::vector<double>().max_size() + 1);
                                   })}) {
        CHECK(problem.what == "there is not enough memory");
        CHECK_FALSE(problem.fix.empty());
    }
}

TEST_CASE("a refused thread comes with what to do; other exceptions say what they say") {
    const auto refused = std::make_error_code(std::errc::resource_unavailable_try_again);
    const Problem threads = problem_in([&] { throw std::system_error(refused, "only 2 of 4 threads"); });
    CHECK(threads.what == "only 2 of 4 threads: " + refused.message());
    CHECK(threads.fix == "ask for fewer threads, or end other programs");
    const Problem missing = problem_in([] { (void)std::filesystem::file_size("/nowhere/at/all"); });
    CHECK(missing.what.find("/nowhere/at/all") != std::string::npos);
    CHECK(missing.fix.empty());
    CHECK(problem_in([] { throw std::runtime_error("so"); }).what == "so");
}

} // namespace test_thrown
