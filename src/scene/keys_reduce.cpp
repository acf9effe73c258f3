#include "scene/key_maker.h"
#include "scene/read_clump.h"

namespace tumble::scene {
namespace {

KeyTable reduce() {
    KeyTable table{.path = "reduce", .head = "[reduce]"};
    table.sentence = "What makes the scene cheaper and a little wrong: docs/reduced-order.md says what each does, and "
                     "`tumble reduce` measures its price. Every default leaves the scene as it is.";
    table.keys = {
        number("softening", "", from(1, 1e6),
               "Young's moduli and stiffnesses of all materials are divided by it, works of adhesion by its power 2/5; "
               "the step gets longer as impacts do: by its power 2/5 for `normal = \"hertz\"`, by its root for "
               "\"linear\".")
            .otherwise(1.0),
        number("size", "", from(1, 100),
               "Size factor of every body that comes in numbers: so many times as long, of the same density, and as "
               "many times fewer as each is heavier. The step gets longer by the same factor.")
            .otherwise(1.0),
        integer("spheres", from(0, static_cast<double>(most_spheres)),
                "So many spheres for each body that says which cone its spheres stand for and has more; their union "
                "keeps its volume. 0: as they are.")
            .in_3d()
            .otherwise(std::int64_t{0}),
        number("slice", "", above(0, 1),
               "Share of the length in the periodic direction that is kept, about its middle, with as large a share of "
               "the bodies.")
            .otherwise(1.0),
    };
    return table;
}

} // namespace

std::vector<KeyTable> reduce_tables() {
    return {reduce()};
}

} // namespace tumble::scene
