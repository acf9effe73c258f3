#pragma once

#include "base/stop.h"
#include "view/inbox.h"
#include "view/jpeg.h"
#include "view/server.h"
#include "view/studio.h"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>

namespace tumble::view {

/// Wakes whoever draws; from any thread.
class Bell {
public:
    void ring();
    /// Until it was rung, at most so long.
    void wait(std::chrono::milliseconds most);

private:
    std::mutex mutex_;
    std::condition_variable rung_;
    bool ringing_ = false;
};

struct ViewerOptions {
    int port = 0;     // 0: any that is free
    int quality = 80; // of JPEG, 1 to 100
    Limits limits{};
};

/// A studio and those who watch it.
class Viewer {
public:
    /// The bell is that of the studio's source. `new_link` is told the first link, and each that takes its place.
    /// Problems: those of Server::open.
    static Result<std::unique_ptr<Viewer>> open(std::unique_ptr<Studio> studio, std::shared_ptr<Bell> bell,
                                                const ViewerOptions& options,
                                                std::function<void(const std::string& link)> new_link);

    /// Takes what hands did and draws while anybody watches, on the calling thread, until the stop. Problems: a frame
    /// that could not be drawn or packed.
    Result<Done> run(StopFlag stop);

    [[nodiscard]] const Server& server() const { return *server_; }

private:
    Viewer(std::unique_ptr<Studio> studio, std::shared_ptr<Bell> bell, int quality);
    void take_messages();
    Result<Done> show_frame();
    void keep_points();

    std::unique_ptr<Studio> studio_;
    std::shared_ptr<Bell> bell_;
    JpegEncoder jpeg_;
    std::chrono::steady_clock::time_point points_kept_;
    std::mutex mutex_; // of the two below
    Inbox inbox_;
    bool joined_ = false;
    std::optional<Server> server_; // last: its thread fills the inbox
};

} // namespace tumble::view
