#pragma once

#include <string>

namespace tumble::render {

/// Why no body is to be seen in a picture.
enum class Bare { no, without_bodies, clipped_away, out_of_view, out_of_corners };

/// Of pictures that stand in one: no where bodies are to be seen in some of them, else the first reason.
template <class Works> Bare bare_of(const Works& works) {
    Bare all = Bare::no;
    for (const auto& work : works) {
        if (work.bare == Bare::no) {
            return Bare::no;
        }
        all = all == Bare::no ? work.bare : all;
    }
    return all;
}

/// A warning about `where` ("this picture") and what to do; nothing where bodies are to be seen.
std::string bare_words(Bare bare, const std::string& where);

} // namespace tumble::render
