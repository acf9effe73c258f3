#include "render/draw_crew.h"

#include "base/thrown.h"

#include <algorithm>
#include <thread>

namespace tumble::render {

constexpr unsigned most_threads = 8;

Result<std::unique_ptr<Crew>> gather_draw_crew() {
    const unsigned cores = std::thread::hardware_concurrency();
    try {
        return std::make_unique<Crew>(static_cast<int>(std::clamp(cores, 1U, most_threads)));
    } catch (const std::exception& refused) {
        return problem_of(refused);
    }
}

} // namespace tumble::render
