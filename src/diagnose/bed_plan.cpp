#include "diagnose/bed_plan.h"

#include "diagnose/bed_number.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace tumble::diagnose {

namespace {

/// A condition that could be measured besides, made as a cause of the library would make it.
struct PlannedBed {
    const char* id;
    const char* sentence;
    const char* cause;
    double amplitude;
};

constexpr PlannedBed planned_beds[] = {
    {"half-load", "measure the same numbers with half the load, too", "load.fill", -0.5},
    {"shaken-less", "measure the same numbers at two thirds of the shaking, too", "exc.gain", -1.0 / 3},
    {"leaning", "let the whole lean by 3 degrees, towards +x, and measure the same numbers there, too", "grav.tilt_x",
     3},
};

/// What is asked of two rivals: under these conditions, with one more number where `more` is none of theirs.
struct Question {
    std::vector<const BedCondition*> conditions;
    int more = -1;         // a column; -1: none
    std::string measure{}; // its name
};

/// What a laboratory reads at best, by the unit: a number that no seed changes is not known without end.
constexpr std::pair<const char*, double> finest[] = {
    {"m", 1e-4}, {"m_s", 1e-3}, {"rad_s", 1e-3}, {"deg", 0.1}, {"", 1e-3}};

double scatter_in_column(const BedCondition& now, int column) {
    return std::sqrt(now.scatter.covariance(column, column));
}

/// A number that scatters so much in the simulation, and no less than can be read.
BulkNumber readable(const std::string& measure, double scatter) {
    const auto unit = unit_of_number(bed_number_named(measure));
    BulkNumber number{.measure = measure, .unit = unit ? *unit : "", .value = 0, .sigma = scatter};
    for (const auto& [name, least] : finest)
        if (number.unit == name)
            number.sigma = std::max(scatter, least);
    return number;
}

constexpr int amplitudes_of_one = 61; // of a rival's amplitude
constexpr int amplitudes_of_two = 15; // along each of two

class Planning {
public:
    Planning(Beds& beds, const BedModel& model, std::vector<Rival> rivals)
        : beds_(beds), model_(model), rivals_(std::move(rivals)) {
        for (const BedCondition& now : model.conditions())
            if (!now.measured.held_out)
                fitted_.push_back(&now);
    }

    std::vector<Proposal> propose(bool run_more) {
        const double now = least_apart({fitted_});
        std::vector<Proposal> proposals{proposal_of(
            "more-runs", "measure the same numbers again, and simulate as many more seeds", std::sqrt(2) * now, now)};
        const double again = proposals[0].separation;
        const auto offer = [&](const std::string& id, const std::string& sentence, double apart, double otherwise) {
            if (apart > worth_it * otherwise)
                proposals.push_back(proposal_of(id, sentence, apart, now));
        };
        for (std::size_t m = 0; m < beds_.measures().size(); ++m) {
            const std::string& measure = beds_.measures()[m];
            offer(measure, fmt::format("measure the same again, and {} of the bed, too", measure),
                  std::hypot(now, least_apart({fitted_, static_cast<int>(m), measure})), again);
        }
        for (const PlannedBed& experiment : planned_beds)
            if (run_more)
                offer(experiment.id, experiment.sentence, with(experiment), now);
        std::stable_sort(proposals.begin(), proposals.end(),
                         [](const Proposal& a, const Proposal& b) { return a.separation > b.separation; });
        return proposals;
    }

private:
    /// 0 where it cannot be run, or is the condition that there was.
    double with(const PlannedBed& experiment) {
        const Cause cause = choose_causes({experiment.cause}, Data::beds)->front();
        Bulk bulk = fitted_[0]->measured;
        bulk.condition += fmt::format(", {}", experiment.id);
        bulk.change = [cause, &experiment](scene::Scene& scene) { cause.extend(scene, experiment.amplitude); };
        if (beds_.idle(0, {{&cause, experiment.amplitude}}))
            return 0;
        const auto added = beds_.add(bulk);
        if (!added)
            return 0;
        std::vector<int> causes;
        for (const Rival& rival : rivals_)
            causes.insert(causes.end(), rival.causes.begin(), rival.causes.end());
        const auto planned = model_.planned(*added, bulk, causes);
        if (!planned)
            return 0;
        std::vector<const BedCondition*> conditions = fitted_;
        conditions.push_back(&*planned);
        return least_apart({conditions});
    }

    [[nodiscard]] double least_apart(const Question& question) const {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < rivals_.size(); ++i)
            for (std::size_t j = 0; j < rivals_.size(); ++j)
                if (i != j)
                    least = std::min(least, apart(question, rivals_[i], rivals_[j]));
        return least;
    }

    [[nodiscard]] static VectorXd change_of(const BedCondition& now, const Rival& rival) {
        VectorXd sum = VectorXd::Zero(now.mean.size());
        for (std::size_t k = 0; k < rival.causes.size(); ++k)
            sum += now.branches[static_cast<std::size_t>(rival.causes[k])].change(
                rival.amplitudes[static_cast<Eigen::Index>(k)]);
        return sum;
    }

    /// What is innocent, with a zero of its own for a condition that is only planned, where each has one.
    [[nodiscard]] std::vector<Innocent> innocents_of(const Question& question) const {
        std::vector<Innocent> all = model_.innocents();
        for (const BedCondition* now : question.conditions)
            if (std::find(fitted_.begin(), fitted_.end(), now) == fitted_.end())
                for (const Innocent& one : model_.innocents())
                    if (one.condition == fitted_[0]->measured.condition) {
                        all.push_back(one);
                        all.back().condition = now->measured.condition;
                    }
        return all;
    }

    /// Standard errors between a rival and the best that another can do within the amplitudes that were run.
    [[nodiscard]] double apart(const Question& question, const Rival& a, Rival b) const {
        double least = apart_at(question, a, b);
        const auto count = static_cast<Eigen::Index>(b.causes.size());
        const int along = count == 1 ? amplitudes_of_one : amplitudes_of_two;
        for (int i = 0; i < (count == 1 ? along : along * along); ++i) {
            for (Eigen::Index k = 0; k < count; ++k) {
                const Cause& cause = model_.causes()[static_cast<std::size_t>(b.causes[static_cast<std::size_t>(k)])];
                b.amplitudes[k] = cause.lo + (cause.hi - cause.lo) * (k == 0 ? i % along : i / along) / (along - 1);
            }
            least = std::min(least, apart_at(question, a, b));
        }
        return least;
    }

    /// Standard errors between two rivals where they are, were this measured in as many runs, when what is innocent is
    /// adjusted; less what seeds alone set two ensembles apart.
    [[nodiscard]] double apart_at(const Question& question, const Rival& a, const Rival& b) const {
        const std::vector<Innocent> innocents = innocents_of(question);
        const auto adjusted = static_cast<Eigen::Index>(innocents.size());
        double by_chance = 0;       // of the square
        std::vector<VectorXd> rows; // the difference, then a slope for each innocent
        for (const BedCondition* one : question.conditions) {
            BedCondition now = *one;
            const bool has_it = std::find(now.columns.begin(), now.columns.end(), question.more) != now.columns.end();
            if (question.more >= 0 && !has_it) {
                now.columns.push_back(question.more);
                now.measured.numbers.push_back(readable(question.measure, scatter_in_column(now, question.more)));
            }
            MatrixXd part(static_cast<Eigen::Index>(now.columns.size()), 1 + adjusted);
            part << now.measured_of(change_of(now, a) - change_of(now, b)), innocent_slopes(now, innocents);
            if (!part.allFinite())
                return 0;
            const MatrixXd covariance = now.covariance(beds_.seeds()),
                           by_seeds = 2.0 / beds_.seeds() * now.simulated_covariance();
            by_chance += covariance.llt().solve(by_seeds).trace();
            MatrixXd white(part.rows(), part.cols());
            for (Eigen::Index k = 0; k < part.cols(); ++k)
                white.col(k) = whitened(covariance, part.col(k));
            for (Eigen::Index k = 0; k < white.rows(); ++k)
                rows.emplace_back(white.row(k).transpose());
        }
        for (std::size_t n = 0; n < innocents.size(); ++n)
            if (innocents[n].spread > 0) {
                rows.emplace_back(VectorXd::Zero(1 + adjusted));
                rows.back()[1 + static_cast<Eigen::Index>(n)] = 1 / innocents[n].spread;
            }
        MatrixXd all(static_cast<Eigen::Index>(rows.size()), 1 + adjusted);
        for (std::size_t k = 0; k < rows.size(); ++k)
            all.row(static_cast<Eigen::Index>(k)) = rows[k].transpose();
        const double apart = Projector(all.rightCols(all.cols() - 1)).out(VectorXd(all.col(0))).squaredNorm();
        return std::isfinite(apart) ? std::sqrt(std::max(0.0, apart - by_chance)) : 0;
    }

    Beds& beds_;
    const BedModel& model_;
    std::vector<Rival> rivals_;
    std::vector<const BedCondition*> fitted_;
};

} // namespace

std::vector<Proposal> bed_proposals(Beds& beds, const BedModel& model, const Evidence& evidence,
                                    const Decision& decision, bool run_more) {
    std::vector<Rival> rivals;
    for (const std::vector<int>& causes : rivals_in(decision))
        rivals.push_back({causes, model.refit(evidence, causes).amplitude});
    if (rivals.size() < 2)
        return {};
    return Planning(beds, model, std::move(rivals)).propose(run_more);
}

} // namespace tumble::diagnose
