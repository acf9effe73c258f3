#include "synthetic.h"

#include "base/table.h"

namespace tumble::excitation::testing {

std::string csv_of(const Record& record) {
    std::vector<std::string> heads{"t_s"};
    for (const Channel& channel : record.channels)
        heads.push_back(channel.name + "_m_s2");
    std::string text = csv_line(heads);
    for (std::size_t k = 0; k < record.time.size(); ++k) {
        std::vector<double> row{record.time[k]};
        for (const Channel& channel : record.channels)
            row.push_back(channel.values[k]);
        text += csv_line(row);
    }
    return text;
}

} // namespace tumble::excitation::testing
