#include "scene/read_toml.h"

#include "scene/nesting.h"

#include <algorithm>
#include <exception>
#include <fmt/format.h>
#include <toml++/toml.h>

namespace tumble::scene {
namespace {

class Copier {
public:
    explicit Copier(std::shared_ptr<const std::string> source) : source_(std::move(source)) {}

    Node copy(const toml::node& from) const {
        Node to;
        to.place = place_of(from.source());
        if (const auto* table = from.as_table())
            to.value = copy_table(*table);
        else if (const auto* array = from.as_array())
            to.value = copy_array(*array);
        else if (const auto* text = from.as_string())
            to.value = text->get();
        else if (const auto* whole = from.as_integer())
            to.value = whole->get();
        else if (const auto* number = from.as_floating_point())
            to.value = number->get();
        else if (const auto* flag = from.as_boolean())
            to.value = flag->get();
        return to;
    }

private:
    Place place_of(const toml::source_region& region) const {
        return {source_, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
    }

    Table copy_table(const toml::table& from) const {
        Table to;
        for (const auto& [name, node] : from)
            to.entries.push_back({std::string(name.str()), place_of(name.source()), copy(node)});
        // toml++ sorts tables by name; people meet problems, and bodies their numbers, in the order written.
        std::stable_sort(to.entries.begin(), to.entries.end(), [](const Entry& a, const Entry& b) {
            return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
        });
        return to;
    }

    Array copy_array(const toml::array& from) const {
        Array to;
        for (const toml::node& item : from)
            to.items.push_back(copy(item));
        return to;
    }

    std::shared_ptr<const std::string> source_;
};

} // namespace

Result<Node> parse_toml(std::string_view text, const std::string& source) {
    if (const auto deep = too_deep_at(text))
        return Problem{source,
                       deep->line,
                       deep->column,
                       "",
                       fmt::format("nested more than {} deep", deepest_nesting),
                       "a scene needs at most 4 levels; look for a bracket that is not closed"};
    try {
        const toml::table root = toml::parse(text, source);
        return Copier(std::make_shared<const std::string>(source)).copy(root);
    } catch (const toml::parse_error& error) {
        const auto where = error.source().begin;
        return Problem{source,
                       static_cast<int>(where.line),
                       static_cast<int>(where.column),
                       "",
                       fmt::format("this is not TOML: {}", error.description()),
                       "see https://toml.io for how values, lists and tables are written"};
    } catch (const std::exception& error) {
        return Problem{source, 0, 0, "", fmt::format("the text cannot be read: {}", error.what()), ""};
    }
}

} // namespace tumble::scene
