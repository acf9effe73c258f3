#pragma once

#include "diagnose/cause.h"
#include "diagnose/measurement.h"
#include "diagnose/simulate.h"
#include "scene/override.h"

#include <Eigen/Core>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace tumble::diagnose {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A scene as text with what was set on the command line, so that it can be read again with other values.
struct SceneText {
    std::string toml;
    std::filesystem::path file;
    std::vector<scene::Override> sets{};
};

/// One number that a fit may adjust: a nuisance, or the amplitude of a cause.
struct Parameter {
    std::string name;
    double start = 0;
    double lo = 0;
    double hi = 0;
    double spread = 0;  // prior standard deviation about start; 0: none
    double step = 0;    // for difference quotients, about one standard error of the data
    int record = -1;    // the only one it acts on; -1: all
    int nuisance = -1;  // which of the measurement's it is; -1: a cause
    bool exact = false; // acts on the instrument alone, to both sides: differences may be small
};

/// One reading that a fit compares.
struct Row {
    int record = 0;
    int channel = 0;
    double time = 0;
};

/// From parameters to readings: the scene with a nuisance's values and a cause's extension, run once for each distinct
/// experiment, seen through the instrument. Runs are remembered, so that what only the instrument changes costs
/// nothing.
class Model {
public:
    /// `records`: those to be predicted. Parameters are the measurement's nuisances, then the causes. Problems: the
    /// scene cannot be read or set as the measurement asks; a nuisance that is no number of the scene.
    static Result<Model> make(SceneText scene, std::vector<Record> records, const std::vector<Nuisance>& nuisances,
                              std::vector<Cause> causes, Simulate simulate);

    [[nodiscard]] const std::vector<Parameter>& parameters() const { return parameters_; }
    [[nodiscard]] std::vector<Parameter>& parameters() { return parameters_; }
    [[nodiscard]] int nuisances() const { return static_cast<int>(parameters_.size() - causes_.size()); }
    /// Index of a cause's amplitude among the parameters.
    [[nodiscard]] int parameter_of(int cause) const { return nuisances() + cause; }
    [[nodiscard]] const std::vector<Cause>& causes() const { return causes_; }
    [[nodiscard]] const std::vector<Record>& records() const { return records_; }
    [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
    [[nodiscard]] const Record& record_of(const Row& row) const {
        return records_[static_cast<std::size_t>(row.record)];
    }
    [[nodiscard]] const Channel& channel_of(const Row& row) const {
        return record_of(row).channels[static_cast<std::size_t>(row.channel)];
    }
    [[nodiscard]] const VectorXd& readings() const { return readings_; }
    [[nodiscard]] VectorXd start() const;
    /// Simulated seconds so far, and runs.
    [[nodiscard]] double simulated() const { return simulated_; }
    [[nodiscard]] int runs() const { return runs_; }

    /// Of each measure and sensor the largest magnitude in any record, SI: a range that is clipped is a share of it.
    using Ranges = std::map<std::pair<std::string, std::string>, double>;
    Result<Ranges> ranges_at(const VectorXd& values);
    /// What reads these records has read others, too: its range is theirs, whatever is fitted here.
    void share_sensors(Ranges ranges) { ranges_ = std::move(ranges); }

    /// What every row should read. Only rows up to `horizon` (a share of each record's length) are worth reading; the
    /// runs end there. Problems: those of the scene or of the run, such as a value that no simulation can have.
    Result<VectorXd> predict(const VectorXd& values, double horizon = 1);

    /// Runs, side by side, what predict() will ask for at these points and is not remembered. Where one thread
    /// simulates this is left to predict().
    void run_ahead(const std::vector<VectorXd>& points, double horizon);

    /// The signals that a record's rows are read from, a channel each, at these values.
    Result<std::vector<Signal>> signals(const VectorXd& values, int record, double horizon = 1);

    /// The scene of a record with these values in it; record -1: the scene as it is, without any record's sets.
    [[nodiscard]] Result<scene::Scene> scene_at(const VectorXd& values, int record) const;
    /// The instrument that a channel of a record was read through.
    [[nodiscard]] Instrument instrument_at(const VectorXd& values, int record, const Channel& channel) const;

private:
    Model() = default;

    Result<Done> find_starts();
    /// Of every record, a signal for each channel.
    Result<std::vector<std::vector<Signal>>> all_signals(const VectorXd& values, double horizon);
    [[nodiscard]] Ranges ranges_of(const std::vector<std::vector<Signal>>& truths) const;
    /// What the command line and a record set; then a parameter's value over it.
    [[nodiscard]] std::vector<scene::Override> written_sets(int record) const;
    [[nodiscard]] std::vector<scene::Override> sets_at(const VectorXd& values, int record) const;
    [[nodiscard]] std::string key_of(const VectorXd& values, int record, double horizon) const;
    /// The scene of a record, as it is run for that.
    [[nodiscard]] Result<scene::Scene> scene_to_run(const VectorXd& values, int record, double horizon) const;
    void make_room(std::size_t runs);
    using Ran = std::shared_ptr<const observe::Series>;
    const Ran& remember(const std::string& text, const scene::Scene& scene, observe::Series series);
    Result<const observe::Series*> run(const VectorXd& values, int record, double horizon);

    SceneText text_;
    std::vector<Record> records_;
    std::vector<Nuisance> nuisance_of_; // of each nuisance parameter
    std::vector<Cause> causes_;
    Simulate simulate_;
    std::vector<Parameter> parameters_;
    std::vector<Row> rows_;
    VectorXd readings_;
    Ranges ranges_;                         // that others know
    std::map<std::string, Ran> remembered_; // by what was asked for
    std::map<std::string, Ran> of_scene_;   // by the scene that it came to: causes that change nothing cost nothing
    double simulated_ = 0;
    int runs_ = 0;
};

} // namespace tumble::diagnose
