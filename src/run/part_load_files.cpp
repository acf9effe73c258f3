#include "base/table.h"
#include "observe/whole_file.h"
#include "run/part_loads.h"
#include "solid/hex_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>

namespace tumble::run {

namespace {

using Eigen::Vector3d;
using Row = std::vector<double>;

constexpr double not_there = std::numeric_limits<double>::quiet_NaN();

const std::vector<std::string> contact_heads{"time_s", "body",   "triangle", "x_m",    "y_m",  "z_m",
                                             "nx",     "ny",     "nz",       "fx_N",   "fy_N", "fz_N",
                                             "vx_m_s", "vy_m_s", "vz_m_s",   "patch_m"};
const std::vector<std::string> mean_heads{"time_s", "window_s", "triangle", "x_m",  "y_m",  "z_m",    "nx",
                                          "ny",     "nz",       "fx_N",     "fy_N", "fz_N", "patch_m"};
const std::string since_head = "since_last_s"; // nan of a row's first touch, so that nothing reads it back
const std::vector<std::string> peak_heads{"peak_normal_s",
                                          "peak_shear_s"}; // folders of before they were kept have none
const std::vector<std::string> touch_heads{"body",
                                           "touch",
                                           "begin_s",
                                           "duration_s",
                                           since_head,
                                           "element",
                                           "x_m",
                                           "y_m",
                                           "z_m",
                                           "approach_m_s",
                                           "slip_m_s",
                                           "peak_normal_N",
                                           "peak_shear_N",
                                           "normal_impulse_N_s",
                                           "shear_impulse_N_s",
                                           peak_heads[0],
                                           peak_heads[1]};

void add(Row& row, const Vector3d& vector) {
    row.insert(row.end(), vector.data(), vector.data() + 3);
}

std::string contacts_csv(const PartLoads& loads) {
    std::string text = csv_line(contact_heads);
    for (const LoadInstant& instant : loads.instants) {
        if (instant.pushes.empty()) // the instant is kept all the same
            text += csv_line(Row{instant.time, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
        for (const observe::WallPush& push : instant.pushes) {
            Row row{instant.time, static_cast<double>(push.body), static_cast<double>(push.triangle)};
            for (const Vector3d& vector : {push.foot, push.normal, push.force, push.velocity})
                add(row, vector);
            row.push_back(push.patch);
            text += csv_line(row);
        }
    }
    return text;
}

std::string means_csv(const PartLoads& loads) {
    std::string text = csv_line(mean_heads);
    for (const MeanLoad& mean : loads.means) {
        if (mean.pushes.empty()) // the window is kept all the same
            text += csv_line(Row{mean.time, mean.window, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
        for (const observe::WallPush& push : mean.pushes) {
            Row row{mean.time, mean.window, static_cast<double>(push.triangle)};
            for (const Vector3d& vector : {push.foot, push.normal, push.force})
                add(row, vector);
            row.push_back(push.patch);
            text += csv_line(row);
        }
    }
    return text;
}

std::string touches_csv(const PartLoads& loads, const solid::HexMesh& mesh) {
    std::string text = csv_line(touch_heads);
    for (const observe::Touching& touch : loads.touches) {
        const auto facet = static_cast<std::size_t>(touch.triangle / 2);
        Row row{static_cast<double>(touch.body),
                static_cast<double>(touch.number),
                touch.begin,
                touch.duration,
                touch.since,
                static_cast<double>(mesh.hex_numbers[static_cast<std::size_t>(mesh.facets[facet].hex)])};
        add(row, touch.foot);
        for (const double value :
             {touch.approach, touch.slip, touch.peak_normal, touch.peak_shear, touch.normal_impulse,
              touch.shear_impulse, touch.peak_normal_time, touch.peak_shear_time})
            row.push_back(value);
        text += csv_line(row);
    }
    return text;
}

std::string bulk_csv(const observe::Series& bulk) {
    std::string text = csv_line(bulk.columns);
    for (std::size_t r = 0; r < bulk.rows(); ++r) {
        Row row;
        for (const std::vector<double>& column : bulk.values)
            row.push_back(column[r]);
        text += csv_line(row);
    }
    return text;
}

/// Columns of a table in the order of its heads; NaN for those that are not read back or may be missing.
Result<std::vector<std::vector<double>>> columns_of(const Table& table, const std::vector<std::string>& heads) {
    std::vector<std::vector<double>> columns;
    Problems problems;
    for (const std::string& head : heads) {
        const bool is_peak = std::find(peak_heads.begin(), peak_heads.end(), head) != peak_heads.end();
        auto column = head == since_head || (is_peak && !table.find(head))
                          ? Result<std::vector<double>>(std::vector<double>(table.rows(), not_there))
                          : table.numbers(head);
        for (const Problem& problem : column.problems())
            problems.push_back(problem);
        if (column)
            columns.push_back(std::move(*column));
    }
    if (!problems.empty())
        return problems;
    return columns;
}

Result<Table> table_of(const std::filesystem::path& file) {
    auto text = observe::read_whole(file);
    if (!text)
        return text.problems();
    return parse_table(std::move(*text), file.string());
}

/// What a reader needs of a table: its columns, and the part that they are of.
struct LoadTable {
    const Table& table;
    const solid::HexMesh& mesh;
    std::vector<std::vector<double>> columns{};

    [[nodiscard]] Vector3d vector(std::size_t column, std::size_t row) const {
        return {columns[column][row], columns[column + 1][row], columns[column + 2][row]};
    }
    [[nodiscard]] Problem foreign(std::size_t row, std::size_t column, const std::string& what) const {
        return table.problem_at(row, column, what, "the loads are of another part");
    }
    /// Of column 2.
    [[nodiscard]] std::optional<Problem> no_triangle(std::size_t row) const {
        const double triangle = columns[2][row];
        if (triangle >= 0 && triangle < static_cast<double>(2 * mesh.facets.size()) && triangle == std::floor(triangle))
            return std::nullopt;
        return foreign(row, 2, "the part has no such triangle");
    }
};

std::optional<Problems> read_contacts(const LoadTable& from, PartLoads& loads) {
    const auto& c = from.columns;
    for (std::size_t r = 0; r < from.table.rows(); ++r) {
        if (loads.instants.empty() || c[0][r] != loads.instants.back().time)
            loads.instants.push_back({c[0][r], {}});
        if (c[1][r] == -1)
            continue;
        if (auto wrong = from.no_triangle(r))
            return Problems{std::move(*wrong)};
        loads.instants.back().pushes.push_back({static_cast<std::int64_t>(c[1][r]), static_cast<int>(c[2][r]),
                                                from.vector(3, r), from.vector(6, r), from.vector(9, r),
                                                from.vector(12, r), c[15][r]});
    }
    return std::nullopt;
}

std::optional<Problems> read_means(const LoadTable& from, PartLoads& loads) {
    const auto& c = from.columns;
    for (std::size_t r = 0; r < from.table.rows(); ++r) {
        if (loads.means.empty() || c[0][r] != loads.means.back().time)
            loads.means.push_back({c[0][r], c[1][r], {}});
        if (c[2][r] == -1)
            continue;
        if (auto wrong = from.no_triangle(r))
            return Problems{std::move(*wrong)};
        loads.means.back().pushes.push_back({-1, static_cast<int>(c[2][r]), from.vector(3, r), from.vector(6, r),
                                             from.vector(9, r), Vector3d::Zero(), c[12][r]});
    }
    return std::nullopt;
}

/// Of a triangle the file keeps the element; one of its facets stands for it.
std::optional<Problems> read_touches(const LoadTable& from, PartLoads& loads) {
    const auto& c = from.columns;
    std::unordered_map<double, int> facet_of; // by an element's number
    for (std::size_t f = 0; f < from.mesh.facets.size(); ++f)
        facet_of.emplace(from.mesh.hex_numbers[static_cast<std::size_t>(from.mesh.facets[f].hex)], static_cast<int>(f));
    for (std::size_t r = 0; r < from.table.rows(); ++r) {
        observe::Touching touch;
        touch.body = static_cast<std::int64_t>(c[0][r]);
        touch.number = static_cast<int>(c[1][r]);
        touch.begin = c[2][r];
        touch.duration = c[3][r];
        const auto facet = facet_of.find(c[5][r]);
        if (facet == facet_of.end())
            return Problems{from.foreign(r, 5, "the part has no such element at its surface")};
        touch.triangle = 2 * facet->second;
        touch.foot = from.vector(6, r);
        touch.approach = c[9][r];
        touch.slip = c[10][r];
        touch.peak_normal = c[11][r];
        touch.peak_shear = c[12][r];
        touch.normal_impulse = c[13][r];
        touch.shear_impulse = c[14][r];
        touch.peak_normal_time = c[15][r];
        touch.peak_shear_time = c[16][r];
        loads.touches.push_back(touch);
    }
    return std::nullopt;
}

} // namespace

Result<Done> write_loads(const PartLoads& loads, const scene::SpecimenShape& specimen,
                         const std::filesystem::path& folder) {
    const solid::HexMesh& mesh = *specimen.mesh;
    for (const auto& [name, text] :
         {std::pair{"contacts.csv", contacts_csv(loads)}, std::pair{"means.csv", means_csv(loads)},
          std::pair{"touches.csv", touches_csv(loads, mesh)}, std::pair{"bulk.csv", bulk_csv(loads.bulk)}})
        if (const auto written = observe::write_whole(folder / name, text); !written)
            return written;
    return Done{};
}

void remove_loads(const std::filesystem::path& folder) {
    std::error_code ignored;
    for (const char* name : {"contacts.csv", "means.csv", "touches.csv", "bulk.csv"})
        std::filesystem::remove(folder / name, ignored);
}

Result<PartLoads> read_loads(const std::filesystem::path& folder, const scene::SpecimenShape& specimen) {
    PartLoads loads;
    struct File {
        const char* name;
        const std::vector<std::string>& heads;
        std::optional<Problems> (*read)(const LoadTable&, PartLoads&);
    };
    for (const File& file :
         {File{"contacts.csv", contact_heads, read_contacts}, File{"means.csv", mean_heads, read_means},
          File{"touches.csv", touch_heads, read_touches}}) {
        const auto table = table_of(folder / file.name);
        if (!table)
            return table.problems();
        auto columns = columns_of(*table, file.heads);
        if (!columns)
            return columns.problems();
        if (const auto wrong = file.read({*table, *specimen.mesh, std::move(*columns)}, loads))
            return *wrong;
    }
    return loads;
}

} // namespace tumble::run
