#include "../about.h"
#include "view/orbit.h"

#include <doctest/doctest.h>

using namespace tumble;
using namespace tumble::view;
using Eigen::Vector2d, Eigen::Vector3d;
using test::about;

namespace test_orbit {

const render::Area area{0, 0, 800, 600};
const Vector2d middle{400, 300};

scene::Render settings_for(const char* camera, const char* projection) {
    scene::Render settings;
    settings.camera = camera;
    settings.projection = projection;
    settings.view = scene::Box{Vector3d(-1, -1, -1), Vector3d(1, 1, 1)};
    return settings;
}

render::Camera camera_for(const scene::Render& settings) {
    const auto camera = render::make_camera(settings, {settings.view->lo, settings.view->hi}, area);
    REQUIRE(camera.ok());
    return *camera;
}

TEST_CASE("taking hold of a camera does not move the picture: a point keeps its place, in both projections") {
    for (const char* projection : {"orthographic", "perspective"})
        for (const char* name : {"front", "side", "free"}) {
            CAPTURE(projection);
            CAPTURE(name);
            scene::Render settings = settings_for(name, projection);
            const render::Camera before = camera_for(settings);
            const Orbit orbit(before, area.height(), settings.field_of_view_deg, false);
            orbit.write(settings);
            CHECK(settings.camera == "free");
            const render::Camera after = camera_for(settings);
            const Vector3d point(0.3, -0.2, 0.5);
            CHECK((before.to_picture(point) - after.to_picture(point)).norm() < 1e-6);
        }
}

TEST_CASE("pushing moves the target's place by the pixels of the drag, and zooming keeps what lies under the pointer") {
    scene::Render settings = settings_for("side", "orthographic");
    Orbit orbit(camera_for(settings), area.height(), settings.field_of_view_deg, false);
    orbit.write(settings);
    const Vector3d point(0.4, 0.1, -0.3);
    const Vector2d at = camera_for(settings).to_picture(point);
    orbit.push(37, -21);
    orbit.write(settings);
    CHECK((camera_for(settings).to_picture(point) - at - Vector2d(37, -21)).norm() < 1e-6);
    const Vector2d held = camera_for(settings).to_picture(point);
    const double scale = camera_for(settings).scale;
    orbit.zoom(1.5, held.x() - middle.x(), held.y() - middle.y());
    orbit.write(settings);
    CHECK((camera_for(settings).to_picture(point) - held).norm() < 1e-6);
    CHECK(camera_for(settings).scale == about(1.5 * scale, 1e-9));
}

TEST_CASE("600 pixels of dragging are half a turn, and the eye never goes over the top") {
    scene::Render settings = settings_for("side", "orthographic");
    Orbit orbit(camera_for(settings), area.height(), settings.field_of_view_deg, false);
    orbit.turn(600, 0); // from +z to -z
    orbit.write(settings);
    const Vector3d away = (settings.eye - settings.target).normalized();
    CHECK((away - Vector3d(0, 0, -1)).norm() < 1e-9);
    orbit.turn(0, 5000);
    orbit.write(settings);
    const Vector3d steep = (settings.eye - settings.target).normalized();
    CHECK(steep.y() > 0.999);
    CHECK(steep.y() < 1);
    CHECK(camera_for(settings).axes.row(0).isApprox(Eigen::RowVector3d(-1, 0, 0), 1e-6)); // still level
}

TEST_CASE("scenes of two dimensions are pushed where others turn") {
    scene::Render settings = settings_for("side", "orthographic");
    Orbit orbit(camera_for(settings), area.height(), settings.field_of_view_deg, true);
    orbit.write(settings);
    const Vector2d at = camera_for(settings).to_picture(Vector3d::Zero());
    orbit.turn(50, 10);
    orbit.write(settings);
    CHECK((camera_for(settings).to_picture(Vector3d::Zero()) - at - Vector2d(50, 10)).norm() < 1e-6);
    CHECK(((settings.eye - settings.target).normalized() - Vector3d::UnitZ()).norm() < 1e-9);
}

} // namespace test_orbit
