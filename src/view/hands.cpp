#include "view/hands.h"

#include <array>
#include <imgui.h>
#include <string_view>

namespace tumble::view {

namespace {

struct KnownKey {
    std::string_view code; // KeyboardEvent.code
    ImGuiKey_ key;
};
constexpr std::array<KnownKey, 16> keys{{{"Tab", ImGuiKey_Tab},
                                         {"ArrowLeft", ImGuiKey_LeftArrow},
                                         {"ArrowRight", ImGuiKey_RightArrow},
                                         {"ArrowUp", ImGuiKey_UpArrow},
                                         {"ArrowDown", ImGuiKey_DownArrow},
                                         {"Home", ImGuiKey_Home},
                                         {"End", ImGuiKey_End},
                                         {"Delete", ImGuiKey_Delete},
                                         {"Backspace", ImGuiKey_Backspace},
                                         {"Space", ImGuiKey_Space},
                                         {"Enter", ImGuiKey_Enter},
                                         {"NumpadEnter", ImGuiKey_KeyPadEnter},
                                         {"Escape", ImGuiKey_Escape},
                                         {"KeyA", ImGuiKey_A},
                                         {"KeyX", ImGuiKey_X},
                                         {"KeyC", ImGuiKey_C}}};

void tell_key(ImGuiIO& io, const KeyChanged& change) {
    io.KeyShift = change.shift;
    io.KeyCtrl = change.ctrl;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        io.KeyMap[keys[i].key] = static_cast<int>(i);
        if (keys[i].code == change.key)
            io.KeysDown[i] = change.down;
    }
}

bool changes_button(const Message& message) {
    return std::holds_alternative<PointerPressed>(message) || std::holds_alternative<PointerReleased>(message);
}

/// Whether the frame is full with it.
struct Tell {
    ImGuiIO& io;

    void go_to(double x, double y) const { io.MousePos = {static_cast<float>(x), static_cast<float>(y)}; }
    bool operator()(const PointerMoved& m) const {
        go_to(m.x, m.y);
        return false;
    }
    bool operator()(const PointerPressed& m) const {
        go_to(m.x, m.y);
        io.MouseDown[m.button] = true;
        return true;
    }
    bool operator()(const PointerReleased& m) const {
        go_to(m.x, m.y);
        io.MouseDown[m.button] = false;
        return true;
    }
    bool operator()(const WheelTurned& m) const {
        go_to(m.x, m.y);
        io.MouseWheel += static_cast<float>(m.notches);
        return false;
    }
    bool operator()(const KeyChanged& m) const {
        tell_key(io, m);
        return true;
    }
    bool operator()(const TextTyped& m) const {
        io.AddInputCharactersUTF8(m.text.c_str());
        return false;
    }
    template <class Other> bool operator()(const Other& /*not for the panel*/) const { return false; }
};

} // namespace

void Hands::feed(double seconds) {
    ImGuiIO& io = ImGui::GetIO();
    io.DeltaTime = static_cast<float>(seconds > 0 ? seconds : 1e-3);
    // A press or release comes first in its frame: a slider would not follow a move that comes with its release.
    bool full = false;
    for (bool first = true; !waiting_.empty() && !full && (first || !changes_button(waiting_.front())); first = false) {
        full = std::visit(Tell{io}, waiting_.front());
        waiting_.pop_front();
    }
}

} // namespace tumble::view
