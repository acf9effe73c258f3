#include "base/table.h"
#include "base/text.h"
#include "fem/vtu.h"
#include "observe/whole_file.h"
#include "stress/facet_loads.h"
#include "stress/study_sheet.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace tumble::stress {

namespace {

namespace fs = std::filesystem;

constexpr const char* settings_file = "study.txt";

using Row = std::vector<double>;

void add(Row& row, const Eigen::Vector3d& vector) {
    row.insert(row.end(), vector.data(), vector.data() + 3);
}

std::string cases_csv(const Study& study) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const std::vector<std::string> heads{"time_s",
                                         "contacts",
                                         "fx_N",
                                         "fy_N",
                                         "fz_N",
                                         "support_fx_N",
                                         "support_fy_N",
                                         "support_fz_N",
                                         "strongest_body",
                                         "strongest_element",
                                         "strongest_face",
                                         "strongest_x_m",
                                         "strongest_y_m",
                                         "strongest_z_m",
                                         "strongest_normal_N",
                                         "strongest_shear_N",
                                         "facet_normal_Pa",
                                         "facet_shear_Pa",
                                         "surface_normal_Pa",
                                         "surface_shear_Pa",
                                         "von_mises_Pa",
                                         "deflection_m",
                                         "residual",
                                         "unbalance"};
    std::string text = csv_line(heads);
    for (const Case& now : study.cases) {
        Row row{now.time, now.window > 0 ? none : static_cast<double>(now.contacts)};
        add(row, now.force);
        add(row, now.support_force);
        if (now.strongest) {
            const Strongest& most = *now.strongest;
            row.push_back(static_cast<double>(most.body));
            row.push_back(most.element);
            row.push_back(most.face);
            add(row, most.foot);
            row.push_back(most.normal);
            row.push_back(most.shear);
        } else
            row.insert(row.end(), 8, none);
        for (const double value : {now.facet_normal, now.facet_shear, now.surface_normal, now.surface_shear,
                                   now.von_mises, now.deflection, now.residual, now.unbalance})
            row.push_back(value);
        text += csv_line(row);
    }
    return text;
}

std::string slices_csv(const Study& study) {
    std::string text = "time_s,side,depth_m,normal_Pa,contour_Pa,along_Pa,compression_Pa,tension_Pa,"
                       "mean_compression_Pa,mean_tension_Pa,compressed_points,stretched_points,compressed_area,"
                       "stretched_area,near_edges_Pa,elsewhere_Pa,x_m,y_m,z_m\n";
    for (const Case& now : study.cases)
        for (std::size_t s = 0; s < study.slices.size(); ++s) {
            const fem::SliceFigures& figures = now.slices[s];
            Row row{study.slices[s].depth,
                    figures.normal,
                    figures.contour,
                    figures.along,
                    figures.compression,
                    figures.tension,
                    figures.mean_compression,
                    figures.mean_tension,
                    static_cast<double>(figures.compressed),
                    static_cast<double>(figures.stretched),
                    figures.compressed_area,
                    figures.stretched_area,
                    figures.near_edges,
                    figures.elsewhere};
            add(row, study.slices[s].points[static_cast<std::size_t>(figures.worst_point)].place);
            text += csv_line(Row{now.time});
            text.back() = ',';
            text += study.slices[s].side + "," + csv_line(row);
        }
    return text;
}

} // namespace

Result<std::vector<fs::path>> write_study(const Study& study, const scene::SpecimenShape& specimen,
                                          const run::PartLoads& loads, const fs::path& folder) {
    const solid::HexMesh& mesh = *specimen.mesh;
    std::vector<fs::path> files;
    for (const auto& [name, text] :
         {std::pair{settings_file, study.settings}, std::pair{"cases.csv", cases_csv(study)},
          std::pair{"slices.csv", slices_csv(study)}, std::pair{"facets.csv", facets_csv(loads, mesh)},
          std::pair{"worst.vtu", fem::part_vtu(mesh, study.worst.load, study.worst.displacement, study.worst.stress,
                                               study.cases[study.worst.index].time)}}) {
        files.push_back(folder / name);
        if (const auto written = observe::write_whole(files.back(), text); !written)
            return written.problems();
    }
    return files;
}

std::string kept_settings(const fs::path& folder) {
    const Result<std::string> text = observe::read_whole(folder / settings_file);
    return text ? *text : "";
}

std::string what_differs(const std::string& kept, const std::string& settings) {
    const auto before = split(kept, '\n'), now = split(settings, '\n');
    std::string words;
    for (std::size_t line = 0; line < std::max(before.size(), now.size()); ++line) {
        const std::string_view was = line < before.size() ? before[line] : "", is = line < now.size() ? now[line] : "";
        if (was != is)
            words +=
                fmt::format("{}{}, now {}", words.empty() ? "" : "; ", was.empty() ? "nothing" : was,
                            is.empty()    ? "nothing"
                            : was.empty() ? is
                                          : is.substr(is.find('=') == std::string_view::npos ? 0 : is.find('=') + 2));
    }
    return words;
}

} // namespace tumble::stress
