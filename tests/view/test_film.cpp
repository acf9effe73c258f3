#include "../render/fixtures.h"
#include "keeper.h"
#include "view/film.h"

#include <doctest/doctest.h>

using namespace tumble;
using namespace tumble::view;
using view::testing::Keeper;

namespace test_film {

TEST_CASE("a film's pictures have the camera that was wanted when they were shot, however late they are drawn") {
    const Keeper keeper;
    const auto layout = render::testing::spheres({0.02});
    observe::Frame frame = render::testing::empty_frame(layout);
    render::testing::add_body(frame, 0, {0, 0.03, 0.05}, {1, 0, 0});
    scene::Render settings = render::testing::square_view(0.1);
    settings.width = settings.height = 120;
    scene::Render turned = settings;
    turned.camera = "top";
    const std::filesystem::path file = keeper.folder.path / "film.mp4";
    const Eigen::AlignedBox3d bounds(settings.view->lo, settings.view->hi);
    auto film = Film::open({settings}, layout, file, bounds, 1e-3); // a picture every 40 steps
    REQUIRE_MESSAGE(film.ok(), to_string(film.problems()));
    CHECK((*film)->due(0));
    CHECK((*film)->shoot(0, frame));
    CHECK(!(*film)->due(39));
    CHECK((*film)->next() == 40);
    (*film)->restyle({turned});
    CHECK((*film)->shoot(40, frame));
    CHECK((*film)->shoot(80, frame));
    (*film)->restyle({settings});
    CHECK((*film)->shoot(120, frame));
    CHECK((*film)->close() == file.string() + " with 4 pictures");
    render::Painter painter = render::testing::painter_for(settings, layout, {});
    painter.fit(bounds);
    const auto bytes = [](const render::Picture& picture) {
        return std::string(picture.rgba.begin(), picture.rgba.end());
    };
    const std::string first = bytes(painter.draw(frame));
    REQUIRE(painter.restyle(turned).ok());
    const std::string second = bytes(painter.draw(frame));
    CHECK(first != second);
    CHECK(test::content_of(file) == first + second + second + first);
}

TEST_CASE("a film that cannot be made is a problem, and no film") {
    const test::Folder folder;
    const auto layout = render::testing::spheres({0.02});
    const Eigen::AlignedBox3d bounds(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones());
    CHECK(!Film::open({render::testing::square_view(0.1)}, layout, folder.path / "film.avi", bounds, 1e-3).ok());
    CHECK(std::filesystem::is_empty(folder.path));
}

} // namespace test_film
