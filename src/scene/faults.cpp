#include "scene/faults.h"

#include "scene/keys.h"

#include <fmt/format.h>

namespace tumble::scene {

namespace {

Problem problem_of(const char* key, std::string what, std::string fix) {
    Problem problem;
    problem.key = key;
    problem.what = std::move(what);
    problem.fix = std::move(fix);
    return problem;
}

std::string in_words(const Vector3d& v) {
    return fmt::format("[{}, {}, {}]", plain(v.x()), plain(v.y()), plain(v.z()));
}

} // namespace

Problems faults_of(const ContactLaws& laws, int dimension) {
    Problems problems;
    const bool linear = laws.normal == NormalLaw::linear;
    const contact::AdhesionLaw adhesion = laws.additions.adhesion;
    if (linear && (adhesion == contact::AdhesionLaw::jkr || adhesion == contact::AdhesionLaw::dmt))
        problems.push_back(problem_of(
            "adhesion",
            fmt::format("adhesion = \"{}\" builds on Hertz' contact, which normal = \"linear\" does not have",
                        words_of_adhesion[static_cast<std::size_t>(adhesion)]),
            "write normal = \"hertz\", or adhesion = \"sjkr\""));
    if (linear && laws.tangential == TangentialLaw::mindlin)
        problems.push_back(problem_of(
            "tangential", "normal = \"linear\" does not go with tangential = \"mindlin\", whose stiffness is Hertz'",
            "write tangential = \"linear\" or \"none\", or normal = \"hertz\""));
    if (dimension == 2 && !linear && laws.tangential == TangentialLaw::linear)
        problems.push_back(problem_of("tangential",
                                      "in two dimensions normal = \"hertz\" does not go with tangential = \"linear\"",
                                      "write tangential = \"mindlin\" or \"none\", or normal = \"linear\""));
    return problems;
}

std::optional<Problem> fault_of_inertia(const Vector3d& moments) {
    // The two smaller moments of any real body sum to more than the largest.
    if (moments.allFinite() && moments.minCoeff() > 0 && 2 * moments.maxCoeff() <= moments.sum() * (1 + 1e-9))
        return std::nullopt;
    return problem_of("inertia_kg_m2", fmt::format("no body has the moments {}", in_words(moments)),
                      "each must be above 0, and the largest cannot exceed the sum of the other two");
}

std::optional<Problem> fault_of(const BoxShape& shape) {
    if ((shape.box.lo.array() < shape.box.hi.array()).all())
        return std::nullopt;
    return problem_of(
        "hi_m", fmt::format("the box from {} to {} has no volume", in_words(shape.box.lo), in_words(shape.box.hi)),
        "each value of hi_m must be above that of lo_m");
}

std::optional<Problem> fault_of(const DiscShape& shape) {
    if (shape.hole_radius >= 0 && shape.hole_radius < shape.radius)
        return std::nullopt;
    return problem_of("hole_radius_m",
                      fmt::format("a hole of radius {} m leaves nothing of a disc of {} m", plain(shape.hole_radius),
                                  plain(shape.radius)),
                      "make it smaller than radius_m");
}

std::optional<Problem> fault_of(const TroughShape& shape) {
    if (shape.rim > shape.floor)
        return std::nullopt;
    return problem_of(
        "rim_m", fmt::format("the rim at {} m is not above the floor at {} m", plain(shape.rim), plain(shape.floor)),
        "raise the rim");
}

} // namespace tumble::scene
