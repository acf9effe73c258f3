#include "base/table.h"
#include "observe/whole_file.h"
#include "run/part_loads.h"
#include "solid/hex_mesh.h"

#include <array>
#include <cmath>
#include <map>
#include <unordered_map>

namespace tumble::run {

namespace {

using Eigen::Vector3d;
using Row = std::vector<double>;

const std::vector<std::string> contact_heads{"time_s", "body",   "triangle", "x_m",    "y_m",  "z_m",
                                             "nx",     "ny",     "nz",       "fx_N",   "fy_N", "fz_N",
                                             "vx_m_s", "vy_m_s", "vz_m_s",   "patch_m"};
const std::vector<std::string> mean_heads{"time_s", "window_s", "node", "fx_N", "fy_N", "fz_N"};
const std::vector<std::string> touch_heads{"body",
                                           "touch",
                                           "begin_s",
                                           "duration_s",
                                           "since_last_s",
                                           "element",
                                           "x_m",
                                           "y_m",
                                           "z_m",
                                           "approach_m_s",
                                           "slip_m_s",
                                           "peak_normal_N",
                                           "peak_shear_N",
                                           "normal_impulse_N_s",
                                           "shear_impulse_N_s"};

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

/// Force over area of every facet that is touched, as the thesis plots it; along and across the contacts' normals,
/// which at an edge are not the facet's.
std::string facets_csv(const PartLoads& loads, const solid::HexMesh& mesh) {
    std::string text = "time_s,element,face,area_m2,normal_Pa,shear_Pa\n";
    for (const LoadInstant& instant : loads.instants) {
        struct OnFacet {
            double pressing = 0;                  // N
            Vector3d shearing = Vector3d::Zero(); // N
        };
        std::map<int, OnFacet> facets;
        for (const observe::WallPush& push : instant.pushes) {
            facets[push.triangle / 2].pressing += push.pressing();
            facets[push.triangle / 2].shearing += push.shearing();
        }
        for (const auto& [facet, sum] : facets) {
            const solid::Facet& of = mesh.facets[static_cast<std::size_t>(facet)];
            const double area = mesh.area_of(facet).norm();
            text +=
                csv_line(Row{instant.time, static_cast<double>(mesh.hex_numbers[static_cast<std::size_t>(of.hex)]),
                             static_cast<double>(of.face + 1), area, sum.pressing / area, sum.shearing.norm() / area});
        }
    }
    return text;
}

std::string means_csv(const PartLoads& loads, const solid::HexMesh& mesh) {
    std::string text = csv_line(mean_heads);
    for (const MeanLoad& mean : loads.means) {
        bool any = false;
        for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
            const Vector3d force = mean.force.col(static_cast<Eigen::Index>(n));
            const bool last = n + 1 == mesh.nodes.size();
            if (force.isZero(0) && !(last && !any))
                continue;
            any = true;
            Row row{mean.time, mean.window, static_cast<double>(mesh.node_numbers[n])};
            add(row, force);
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
        for (const double value : {touch.approach, touch.slip, touch.peak_normal, touch.peak_shear,
                                   touch.normal_impulse, touch.shear_impulse})
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

/// Columns of a table in the order of its heads.
Result<std::vector<std::vector<double>>> columns_of(const Table& table, const std::vector<std::string>& heads) {
    std::vector<std::vector<double>> columns;
    Problems problems;
    for (const std::string& head : heads) {
        auto column = table.numbers(head);
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

bool whole_below(double value, std::size_t end) {
    return value >= 0 && value < static_cast<double>(end) && value == std::floor(value);
}

std::optional<Problems> read_contacts(const Table& table, const solid::HexMesh& mesh, PartLoads& loads) {
    const auto columns = columns_of(table, contact_heads);
    if (!columns)
        return columns.problems();
    const auto& c = *columns;
    for (std::size_t r = 0; r < table.rows(); ++r) {
        if (loads.instants.empty() || c[0][r] != loads.instants.back().time)
            loads.instants.push_back({c[0][r], {}});
        if (c[1][r] < 0)
            continue;
        if (!whole_below(c[2][r], 2 * mesh.facets.size()))
            return Problems{table.problem_at(r, 2, "the part has no such triangle", "the loads are of another part")};
        const auto vector = [&](std::size_t k) { return Vector3d(c[k][r], c[k + 1][r], c[k + 2][r]); };
        loads.instants.back().pushes.push_back({static_cast<std::int64_t>(c[1][r]), static_cast<int>(c[2][r]),
                                                vector(3), vector(6), vector(9), vector(12), c[15][r]});
    }
    return std::nullopt;
}

std::optional<Problems> read_means(const Table& table, const solid::HexMesh& mesh, PartLoads& loads) {
    const auto columns = columns_of(table, mean_heads);
    if (!columns)
        return columns.problems();
    std::unordered_map<double, Eigen::Index> index_of; // by a node's number
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
        index_of.emplace(mesh.node_numbers[n], static_cast<Eigen::Index>(n));
    const auto& c = *columns;
    for (std::size_t r = 0; r < table.rows(); ++r) {
        if (loads.means.empty() || c[0][r] != loads.means.back().time)
            loads.means.push_back(
                {c[0][r], c[1][r], Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(mesh.nodes.size()))});
        const auto node = index_of.find(c[2][r]);
        if (node == index_of.end())
            return Problems{table.problem_at(r, 2, "the part has no such node", "the loads are of another part")};
        loads.means.back().force.col(node->second) = Vector3d(c[3][r], c[4][r], c[5][r]);
    }
    return std::nullopt;
}

} // namespace

Result<Done> write_loads(const PartLoads& loads, const scene::SpecimenShape& specimen,
                         const std::filesystem::path& folder) {
    const solid::HexMesh& mesh = *specimen.mesh;
    for (const auto& [name, text] :
         {std::pair{"contacts.csv", contacts_csv(loads)}, std::pair{"means.csv", means_csv(loads, mesh)},
          std::pair{"facets.csv", facets_csv(loads, mesh)}, std::pair{"touches.csv", touches_csv(loads, mesh)},
          std::pair{"bulk.csv", bulk_csv(loads.bulk)}})
        if (const auto written = observe::write_whole(folder / name, text); !written)
            return written;
    return Done{};
}

Result<PartLoads> read_loads(const std::filesystem::path& folder, const scene::SpecimenShape& specimen) {
    PartLoads loads;
    Problems problems;
    const auto contacts = table_of(folder / "contacts.csv"), means = table_of(folder / "means.csv");
    for (const auto* table : {&contacts, &means})
        for (const Problem& problem : table->problems())
            problems.push_back(problem);
    if (!problems.empty())
        return problems;
    if (const auto wrong = read_contacts(*contacts, *specimen.mesh, loads))
        return *wrong;
    if (const auto wrong = read_means(*means, *specimen.mesh, loads))
        return *wrong;
    return loads;
}

} // namespace tumble::run
