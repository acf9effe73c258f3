#pragma once

#include "render/screen_pen.h"

#include <memory>
#include <mutex>

struct ImGuiContext;

namespace tumble::render {

/// Dear ImGui without a window, with the project's letters in sizes for `unit` (pixels; render/layout.h). Loads DejaVu
/// Sans where the system has it, else the small font inside Dear ImGui.
class ImGuiSession {
public:
    explicit ImGuiSession(double unit);
    ImGuiSession(const ImGuiSession&) = delete;
    ImGuiSession& operator=(const ImGuiSession&) = delete;
    ~ImGuiSession();

    [[nodiscard]] const ScreenPen::Fonts& fonts() const { return fonts_; }
    /// Between two frames: letters for another unit; all else goes on as it is.
    void rescale(double unit);

    /// While it lives, ImGui's functions mean this session: there is one current context for all threads.
    class Current {
    public:
        explicit Current(const ImGuiSession& session);

    private:
        std::lock_guard<std::mutex> lock_;
    };

private:
    ImGuiContext* context_ = nullptr;
    ScreenPen::Fonts fonts_;
};

} // namespace tumble::render
