#include "sheet/show.h"

namespace tumble::sheet {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Heading& heading) {
    return {{"heading", heading.text}};
}
Json json_of(const Paragraph& paragraph) {
    return {{"paragraph", paragraph.text}};
}
Json json_of(const Formula& formula) {
    return {{"formula", formula.text}, {"source", formula.source}};
}
Json json_of(const Grid& grid) {
    Json heads = Json::array(), rows = Json::array();
    for (const Column& column : grid.columns)
        heads.push_back({{"head", column.head}, {"unit", column.unit}});
    for (const std::vector<Cell>& cells : grid.rows) {
        rows.push_back(Json::array());
        for (const Cell& cell : cells)
            std::visit([&](const auto& content) { rows.back().push_back(content); }, cell);
    }
    return {{"columns", heads}, {"rows", rows}};
}
Json json_of(const Figure& figure) {
    Json curves = Json::array();
    for (const Curve& curve : figure.curves) {
        curves.push_back({{"label", curve.label}, {"x", curve.x}, {"y", curve.y}});
        if (!curve.spread.empty())
            curves.back()["spread"] = curve.spread;
    }
    return {{"figure", figure.name},
            {"title", figure.title},
            {"x", {{"label", figure.x.label}, {"unit", figure.x.unit}}},
            {"y", {{"label", figure.y.label}, {"unit", figure.y.unit}}},
            {"curves", curves}};
}

Json json_of(const Picture& picture) {
    return {{"picture", picture.name}, {"title", picture.title}, {"note", picture.note}};
}

} // namespace

Json to_json(const Sheet& sheet) {
    Json facts = Json::object(), parts = Json::array();
    for (const Fact& fact : sheet.facts)
        facts[fact.name] = {{"value", fact.value}, {"unit", fact.unit}};
    for (const Part& part : sheet.parts)
        parts.push_back(std::visit([](const auto& one) { return json_of(one); }, part));
    return {{"facts", facts}, {"parts", parts}};
}

} // namespace tumble::sheet
