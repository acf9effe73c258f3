#include "scene/resolve.h"

#include <algorithm>
#include <fmt/format.h>

namespace tumble::scene {
namespace {

/// Two keys of which neither means anything without the other.
void check_both(const View& view, const Resolving& to, const std::string& one, const std::string& other) {
    for (const auto& [there, missing] : {std::pair(one, other), std::pair(other, one)})
        if (view.written(there) && !view.written(missing))
            to.refuse(view, there, fmt::format("{} has '{}' without '{}'", view.title(), there, missing),
                      fmt::format("add {}, or remove {}", missing, there));
}

void resolve_rolling(const View& view, const Resolving& to, contact::PairProperties& properties) {
    properties.rolling_friction = view.number("rolling_friction");
    properties.rolling_damping = view.number("rolling_damping");
    properties.rolling_time = view.number("rolling_time_s");
    const bool chosen = to.scene.written.contains("contact.rolling"); // also where it is "none"
    for (const char* key : {"rolling_friction", "rolling_damping"})
        if (view.written(key) && !chosen)
            to.refuse(view, key, fmt::format("'{}' does nothing, because [contact] chooses no rolling law", key),
                      "write rolling = \"cdt\" or \"epsd\" in [contact], or \"none\" to switch it off");
}

void resolve_adhesion(const View& view, const Resolving& to, contact::PairProperties& properties) {
    if (to.scene.dimension == 2)
        return;
    properties.cohesion_energy = view.number("cohesion_energy_J_m3");
    properties.work_of_adhesion = view.number("work_of_adhesion_J_m2");
    const bool chosen = to.scene.written.contains("contact.adhesion"); // also where it is "none"
    const auto law = to.scene.contact.additions.adhesion;
    const auto refuse = [&](const char* key, const char* laws, bool right) {
        if (!view.written(key) || (chosen && (right || law == contact::AdhesionLaw::none)))
            return;
        to.refuse(view, key,
                  chosen ? fmt::format("'{}' does nothing under adhesion = \"{}\"", key,
                                       words_of_adhesion[static_cast<std::size_t>(law)])
                         : fmt::format("'{}' does nothing, because [contact] chooses no adhesion", key),
                  fmt::format("write adhesion = {} in [contact], or \"none\" to switch it off", laws));
    };
    refuse("cohesion_energy_J_m3", "\"sjkr\"", law == contact::AdhesionLaw::sjkr);
    refuse("work_of_adhesion_J_m2", "\"jkr\" or \"dmt\"",
           law == contact::AdhesionLaw::jkr || law == contact::AdhesionLaw::dmt);
}

void resolve_restitution(const View& view, const Resolving& to, contact::PairProperties& properties) {
    properties.restitution_exponent = view.number("restitution_exponent");
    properties.restitution_speed = view.number("restitution_speed_m_s");
    properties.restitution_most = view.number("restitution_most");
    properties.sticking_speed = view.number("sticking_speed_m_s");
    check_both(view, to, "restitution_exponent", "restitution_speed_m_s");
    if (view.written("restitution_most") && !view.written("restitution_exponent"))
        to.refuse(view, "restitution_most",
                  "'restitution_most' bounds a restitution that falls with speed, and this one does not",
                  "add restitution_exponent and restitution_speed_m_s, or remove it");
    if (properties.sticking_speed > 0 && view.given("restitution") && properties.restitution == 0)
        to.refuse(view, "sticking_speed_m_s", "with a restitution of 0 every impact sticks",
                  "remove sticking_speed_m_s, or give the restitution of fast impacts");
    if (properties.sticking_speed > 0 && properties.damping_time > 0)
        to.refuse(view, "sticking_speed_m_s", "'sticking_speed_m_s' scales restitution, not 'contact_damping_s'",
                  "give restitution in place of contact_damping_s");
    if (properties.restitution_exponent == 0)
        return;
    if (view.given("restitution") && properties.restitution == 0)
        to.refuse(view, "restitution_exponent", "a restitution of 0 cannot fall with speed",
                  "remove restitution_exponent, or give the restitution at restitution_speed_m_s");
    if (view.written("restitution_most") && properties.restitution_most < properties.restitution)
        to.refuse(view, "restitution_most", "'restitution_most' is below 'restitution'", "it is what e(v) is at most");
    if (properties.damping_time > 0)
        to.refuse(view, "restitution_exponent", "'restitution_exponent' scales restitution, not 'contact_damping_s'",
                  "give restitution in place of contact_damping_s");
}

void resolve_friction(const View& view, const Resolving& to, contact::PairProperties& properties) {
    properties.sliding_friction = view.number("sliding_friction");
    properties.sliding_speed = view.number("sliding_speed_m_s");
    check_both(view, to, "sliding_friction", "sliding_speed_m_s");
    if (view.given("sliding_friction") && properties.sliding_friction > properties.friction)
        to.refuse(view, "sliding_friction", "'sliding_friction' is above 'friction', which it is to be less than",
                  "friction holds at rest, sliding_friction in fast sliding");
}

} // namespace

void resolve_additions(const View& pair, const Resolving& to, contact::PairProperties& properties) {
    resolve_rolling(pair, to, properties);
    resolve_restitution(pair, to, properties);
    resolve_friction(pair, to, properties);
    resolve_adhesion(pair, to, properties);
}

void check_additions(const View& root, const Resolving& to) {
    const View contact = root.child("contact");
    const auto pairs = root.children("pair");
    const auto written = [&](const char* key) {
        return std::any_of(pairs.begin(), pairs.end(), [&](const NamedView& pair) { return pair.view.written(key); });
    };
    if (to.scene.contact.additions.rolling != contact::RollingLaw::none && !written("rolling_friction"))
        to.refuse(contact, "rolling",
                  fmt::format("rolling = \"{}\" without a 'rolling_friction' in any pair", contact.text("rolling")),
                  "add rolling_friction to the pairs that roll, or write rolling = \"none\"");
    const auto adhesion = to.scene.contact.additions.adhesion;
    const char* needed = adhesion == contact::AdhesionLaw::sjkr ? "cohesion_energy_J_m3" : "work_of_adhesion_J_m2";
    if (adhesion != contact::AdhesionLaw::none && !written(needed))
        to.refuse(contact, "adhesion",
                  fmt::format("adhesion = \"{}\" without a '{}' in any pair", contact.text("adhesion"), needed),
                  fmt::format("add {} to the pairs that stick, or write adhesion = \"none\"", needed));
}

} // namespace tumble::scene
