#include "render/png_writer.h"

#include "base/png_size.h"
#include "base/thrown.h"
#include "render/file_swap.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <new>
#include <stb/stb_image_write.h>
#include <thread>
#include <utility>

namespace tumble::render {

std::vector<std::uint8_t> encode_png(const Picture& picture) {
    std::vector<std::uint8_t> rgb;
    rgb.reserve(picture.rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
        rgb.insert(rgb.end(), {picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]});
    }
    std::string bytes;
    const auto take = [](void* out, void* data, int size) {
        static_cast<std::string*>(out)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
    };
    if (!stbi_write_png_to_func(take, &bytes, picture.width, picture.height, 3, rgb.data(), 3 * picture.width)) {
        throw std::bad_alloc(); // its one reason
    }
    if (picture.dots_per_metre > 0) {
        insert_png_size(bytes, picture.dots_per_metre);
    }
    return {bytes.begin(), bytes.end()};
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
