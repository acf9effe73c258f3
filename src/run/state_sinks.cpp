#include "run/state_sinks.h"

#include "base/make_folder.h"
#include "observe/frame_file.h"
#include "observe/paraview.h"
#include "observe/text_dump.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

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
    return {.file = file.string(),
            .what = std::string("cannot be written: ") + std::strerror(error),
            .fix = error == ENOSPC ? "free some space, or write to another disk" : ""};
}

class TextSink final : public FrameSink {
public:
    TextSink(std::filesystem::path file, std::FILE* stream) : file_(std::move(file)), stream_(stream) {}
    ~TextSink() override { std::fclose(stream_); }
    TextSink(const TextSink&) = delete;
    TextSink& operator=(const TextSink&) = delete;

    Result<Done> take(const Shot& shot) override {
        const std::string text = observe::text_dump(shot.frame);
        if (std::fwrite(text.data(), 1, text.size(), stream_) == text.size() && std::fflush(stream_) == 0)
            return Done{};
        return cannot_write(file_, errno);
    }

private:
    std::filesystem::path file_;
    std::FILE* stream_;
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
    std::FILE* stream = std::fopen(file.c_str(), "wb");
    if (!stream)
        return cannot_write(file, errno);
    return std::unique_ptr<FrameSink>(std::make_unique<TextSink>(file, stream));
}

} // namespace tumble::run
