#include "view/viewer.h"

#include <chrono>
#include <utility>

namespace tumble::view {

namespace {

using std::chrono::milliseconds;

constexpr milliseconds usual_wait{100};
constexpr milliseconds wait_while_playing{10}; // a recorded run rings no bell
constexpr milliseconds between_points{100};    // of plots that nobody looks at

} // namespace

void Bell::ring() {
    {
        const std::lock_guard lock(mutex_);
        ringing_ = true;
    }
    rung_.notify_all();
}

void Bell::wait(milliseconds most) {
    std::unique_lock lock(mutex_);
    rung_.wait_for(lock, most, [&] { return ringing_; });
    ringing_ = false;
}

Viewer::Viewer(std::unique_ptr<Studio> studio, std::shared_ptr<Bell> bell, int quality)
    : studio_(std::move(studio)), bell_(std::move(bell)), jpeg_(quality) {}

Result<std::unique_ptr<Viewer>> Viewer::open(std::unique_ptr<Studio> studio, std::shared_ptr<Bell> bell,
                                             const ViewerOptions& options,
                                             std::function<void(const std::string& link)> new_link) {
    std::unique_ptr<Viewer> viewer(new Viewer(std::move(studio), std::move(bell), options.quality));
    Viewer& v = *viewer;
    Listener listener;
    listener.message = [&v](const Message& message) {
        {
            const std::lock_guard lock(v.mutex_);
            v.inbox_.add(message);
        }
        v.bell_->ring();
    };
    listener.watcher_joined = [&v] {
        {
            const std::lock_guard lock(v.mutex_);
            v.joined_ = true;
        }
        v.bell_->ring();
    };
    listener.frame_taken = [&v] { v.bell_->ring(); };
    listener.new_link = new_link;
    Result<Server> server = Server::open(options.port, options.limits, std::move(listener));
    if (!server)
        return server.problems();
    viewer->server_.emplace(std::move(*server));
    new_link(viewer->server_->link());
    return viewer;
}

void Viewer::take_messages() {
    const auto next = [this]() -> std::optional<Message> {
        const std::lock_guard lock(mutex_);
        if (inbox_.empty())
            return std::nullopt;
        Message message = inbox_.front();
        inbox_.pop_front();
        return message;
    };
    for (std::size_t taken = 0; taken < 2 * Inbox::most; ++taken) { // then a frame is drawn, however many come
        const std::optional<Message> message = next();
        if (!message)
            return;
        studio_->take(*message);
    }
}

Result<Done> Viewer::show_frame() {
    const Result<Shown> shown = studio_->draw();
    if (!shown)
        return shown.problems();
    Result<std::vector<std::uint8_t>> bytes = jpeg_.encode(shown->picture);
    if (!bytes)
        return bytes.problems();
    server_->show(std::move(*bytes), shown->state);
    return Done{};
}

void Viewer::keep_points() {
    const auto now = std::chrono::steady_clock::now();
    if (!studio_->is_playing() || now - points_kept_ < between_points)
        return;
    points_kept_ = now;
    studio_->keep_points();
}

Result<Done> Viewer::run(StopFlag stop) {
    while (!stop_wanted(stop)) {
        take_messages();
        bool joined = false;
        {
            const std::lock_guard lock(mutex_);
            joined = std::exchange(joined_, false);
        }
        if (joined || (server_->wants_frame() && studio_->is_stale())) {
            if (Result<Done> shown = show_frame(); !shown)
                return shown;
        } else {
            keep_points();
            bell_->wait(studio_->is_playing() ? wait_while_playing : usual_wait);
        }
    }
    return Done{};
}

} // namespace tumble::view
