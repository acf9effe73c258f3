#include "run/state_sinks.h"

#include "base/make_folder.h"
#include "base/remedy.h"
#include "base/write_all.h"
#include "observe/frame_file.h"
#include "observe/paraview.h"
#include "observe/text_dump.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/types.h>
#include <unistd.h>

namespace tumble::run {

namespace {

class StateSink final : public FrameSink {
public:
    explicit StateSink(std::filesystem::path folder) : folder_(std::move(folder)) {}
    Result<Done> take(const Shot& shot) override {
        return shot.again ? Done{} : observe::write_frame(observe::frame_path(folder_, shot.number), shot.frame);
    }

private:
    std::filesystem::path folder_;
};

class ParaviewSink final : public FrameSink {
public:
    explicit ParaviewSink(std::filesystem::path folder) : writer_(std::move(folder)) {}
    Result<Done> take(const Shot& shot) override { return writer_.write(shot.frame, shot.number); }

private:
    observe::ParaviewWriter writer_;
};

Problem cannot_write(const std::filesystem::path& file, int error) {
    return {
        .file = file.string(), .what = std::string("cannot be written: ") + std::strerror(error), .fix = remedy(error)};
}

class TextSink final : public FrameSink {
public:
    TextSink(std::filesystem::path file, int opened) : file_(std::move(file)), opened_(opened) {}
    ~TextSink() override { ::close(opened_); }
    TextSink(const TextSink&) = delete;
    TextSink& operator=(const TextSink&) = delete;

    /// Of a frame that could not be written as a whole nothing stays.
    Result<Done> take(const Shot& shot) override {
        const std::string text = observe::text_dump(shot.frame);
        int error = write_all(opened_, text);
        if (error == 0) {
            size_ += static_cast<off_t>(text.size());
            return Done{};
        }
        if (::ftruncate(opened_, size_) != 0)
            error = errno;
        return cannot_write(file_, error);
    }

private:
    std::filesystem::path file_;
    int opened_;
    off_t size_ = 0;
};

} // namespace

std::unique_ptr<FrameSink> keep_states(std::filesystem::path folder) {
    return std::make_unique<StateSink>(std::move(folder));
}

Result<std::unique_ptr<FrameSink>> keep_for_paraview(std::filesystem::path folder) {
    if (const auto made = make_folder(folder); !made)
        return made.problems();
    return std::unique_ptr<FrameSink>(std::make_unique<ParaviewSink>(std::move(folder)));
}

Result<std::unique_ptr<FrameSink>> keep_as_text(const std::filesystem::path& file) {
    const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (opened < 0)
        return cannot_write(file, errno);
    return std::unique_ptr<FrameSink>(std::make_unique<TextSink>(file, opened));
}

} // namespace tumble::run
