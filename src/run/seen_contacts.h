#pragma once

#include "observe/frame.h"

#include <vector>

namespace tumble::run {

/// A solver's contacts as frames have them.
template <class Pushes> std::vector<observe::FrameContact> seen_contacts(const Pushes& pushes) {
    std::vector<observe::FrameContact> contacts;
    contacts.reserve(pushes.size());
    for (const auto& push : pushes)
        contacts.push_back({push.a, push.b, push.wall, push.point, push.normal, push.force});
    return contacts;
}

} // namespace tumble::run
