#include "render/png_writer.h"

#include "base/thrown.h"
#include "observe/checksum.h"
#include "render/file_swap.h"

#include <cmath>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <new>
#include <stb/stb_image_write.h>
#include <thread>
#include <utility>

namespace tumble::render {

static void put_whole(std::vector<std::uint8_t>& bytes, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) {
        bytes.push_back(static_cast<std::uint8_t>(value >> shift));
    }
}

/// The chunk pHYs (PNG specification, 11.3.5.3): pixels a metre across and along. It stands before the picture's data,
/// right behind the header.
static void insert_size(std::vector<std::uint8_t>& png, double dots_per_metre) {
    constexpr std::ptrdiff_t after_header = 8 + 12 + 13; // signature; length, name, sum and content of IHDR
    const auto dots = static_cast<std::uint32_t>(std::lround(dots_per_metre));
    std::vector<std::uint8_t> content{'p', 'H', 'Y', 's'};
    put_whole(content, dots);
    put_whole(content, dots);
    content.push_back(1); // the unit is the metre
    std::vector<std::uint8_t> chunk;
    put_whole(chunk, static_cast<std::uint32_t>(content.size() - 4));
    chunk.insert(chunk.end(), content.begin(), content.end());
    put_whole(chunk, observe::crc32({reinterpret_cast<const char*>(content.data()), content.size()}));
    png.insert(png.begin() + after_header, chunk.begin(), chunk.end());
}

std::vector<std::uint8_t> encode_png(const Picture& picture) {
    std::vector<std::uint8_t> rgb;
    rgb.reserve(picture.rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
        rgb.insert(rgb.end(), {picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]});
    }
    std::vector<std::uint8_t> bytes;
    const auto take = [](void* out, void* data, int size) {
        const auto* first = static_cast<const std::uint8_t*>(data);
        auto& all = *static_cast<std::vector<std::uint8_t>*>(out);
        all.insert(all.end(), first, first + size);
    };
    if (!stbi_write_png_to_func(take, &bytes, picture.width, picture.height, 3, rgb.data(), 3 * picture.width)) {
        throw std::bad_alloc(); // its one reason
    }
    if (picture.dots_per_metre > 0) {
        insert_size(bytes, picture.dots_per_metre);
    }
    return bytes;
}

/// An exception becomes a problem, for nobody catches it on the writer's thread.
static Problems encode_and_write(const std::filesystem::path& file, const Picture& picture) {
    try {
        return write_file(file, encode_png(picture)).problems();
    } catch (const std::exception& error) {
        Problem problem = problem_of(error);
        problem.file = file.string();
        problem.what = "the picture could not be written: " + problem.what;
        return {problem};
    }
}

struct PngWriter::Inside {
    struct Job {
        std::filesystem::path file;
        Picture picture;
    };
    std::size_t room = 1;
    std::mutex mutex;
    std::condition_variable changed;
    std::deque<Job> waiting;
    Problems problems;
    bool busy = false;
    bool closing = false;
    std::thread worker;

    void work() {
        std::unique_lock lock(mutex);
        while (true) {
            changed.wait(lock, [&] { return closing || !waiting.empty(); });
            if (waiting.empty()) {
                return;
            }
            const Job job = std::move(waiting.front());
            waiting.pop_front();
            busy = true;
            const bool skip = !problems.empty();
            lock.unlock();
            changed.notify_all();
            Problems found;
            if (!skip) {
                found = encode_and_write(job.file, job.picture);
            }
            lock.lock();
            problems.insert(problems.end(), found.begin(), found.end());
            busy = false;
            changed.notify_all();
        }
    }
    static Result<Done> verdict(const Problems& found) { return found.empty() ? Result<Done>(Done{}) : found; }
};

PngWriter::PngWriter(std::size_t room) : inside_(std::make_unique<Inside>()) {
    inside_->room = room > 0 ? room : 1;
    inside_->worker = std::thread([inside = inside_.get()] { inside->work(); });
}

PngWriter::PngWriter(PngWriter&&) noexcept = default;

PngWriter& PngWriter::operator=(PngWriter&& other) noexcept {
    std::swap(inside_, other.inside_);
    return *this;
}

PngWriter::~PngWriter() {
    if (inside_) {
        {
            const std::lock_guard lock(inside_->mutex);
            inside_->closing = true;
        }
        inside_->changed.notify_all();
        inside_->worker.join();
    }
}

Result<Done> PngWriter::add(std::filesystem::path file, Picture picture) {
    Inside& in = *inside_;
    std::unique_lock lock(in.mutex);
    in.changed.wait(lock, [&] { return in.waiting.size() < in.room || !in.problems.empty(); });
    if (in.problems.empty()) {
        in.waiting.push_back({std::move(file), std::move(picture)});
        in.changed.notify_all();
    }
    return Inside::verdict(in.problems);
}

std::optional<Result<Done>> PngWriter::outcome() {
    Inside& in = *inside_;
    const std::lock_guard lock(in.mutex);
    if (!in.waiting.empty() || in.busy) {
        return std::nullopt;
    }
    return Inside::verdict(std::exchange(in.problems, {}));
}

Result<Done> PngWriter::finish() {
    Inside& in = *inside_;
    std::unique_lock lock(in.mutex);
    in.changed.wait(lock, [&] { return in.waiting.empty() && !in.busy; });
    return Inside::verdict(std::exchange(in.problems, {}));
}

} // namespace tumble::render
