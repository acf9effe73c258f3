#include "diagnose/bed_number.h"
#include "diagnose/measurement.h"
#include "scene/key_maker.h"

namespace tumble::diagnose {

namespace {

scene::KeyTable top() {
    using namespace scene;
    const Settings usual;
    return {.path = "",
            .head = "",
            .required = true,
            .sentence = "What was measured, how, and how well.",
            .keys = {
                text("title", "One line saying what this is."),
                words("causes", {}, "Causes or families to consider; all of them without this key.")
                    .otherwise(std::vector<std::string>{}),
                number("alpha_gate", "", above(0, 0.2), "False alarms to accept: any cause named where there is none.")
                    .otherwise(usual.alpha_gate),
                number("alpha_adequacy", "", above(0, 0.2), "False alarms to accept: misfit seen where there is none.")
                    .otherwise(usual.alpha_adequacy),
                number("margin_nats", "", above(0, 50), "By how much a cause must be likelier than every rival.")
                    .otherwise(usual.margin),
            }};
}

scene::KeyTable nuisance() {
    using namespace scene;
    return {
        .path = "nuisance",
        .head = "[[nuisance]]",
        .repeat = Repeat::many,
        .sentence = "Something unknown but innocent, adjusted under every explanation.",
        .keys = {
            text("key", "A key of the scene, such as pair.ball-plate.restitution.").one_of("what"),
            word("instrument", {"clock_offset", "gain", "bias", "drift"}, "A part of the instrument.").one_of("what"),
            text("measure",
                 "Of a bed: a number whose zero is not well known, such as a slope seen by a camera that may "
                 "lean.")
                .one_of("what"),
            text("cause", "Of a bed: a cause of the library that is innocent here, such as fric.factor.")
                .one_of("what"),
            text("sensor", "Whose part of the instrument, where columns name theirs; of all without it."),
            word("per", {"case", "series"}, "One value for all, or one for each series or bulk.")
                .otherwise(std::string("case")),
            number(
                "spread", "unit of the key", above(0),
                "How well it is known beforehand (standard deviation), in the key's unit, the unit that `tumble list "
                "measures` or `tumble list causes` gives, or in SI."),
        }};
}

scene::KeyTable series() {
    using namespace scene;
    return {.path = "series",
            .head = "[[series]]",
            .repeat = Repeat::many,
            .sentence = "What was read while one experiment ran once.",
            .keys = {
                text("name", "What to call it.").must(),
                text("condition", "Series of one condition repeat each other; without this key those of equal set do,"
                                  " unless a nuisance of a key is per series."),
                file("file", "CSV with a column time_s (or time_ms) and those named below.").must(),
                words("set", {}, "Scene keys of this experiment, as --set takes them: \"fill.0.position_m.1=0.3\".")
                    .otherwise(std::vector<std::string>{}),
                flag("held_out", "Keep it for measuring the gain; it is never fitted."),
            }};
}

scene::Key sensor() {
    return scene::text("sensor",
                       "What read it, where several did: what is wrong with one of them is told from the others.");
}

scene::KeyTable column() {
    using namespace scene;
    return {
        .path = "series.column",
        .head = "[[series.column]]",
        .repeat = Repeat::many,
        .required = true,
        .sentence = "One column of readings.",
        .keys = {
            text("head", "Head of the column without its unit: \"height\" finds height_m, height_mm.").must(),
            text("measure", "What it shows: a name of `tumble list measures`, or \"time\" for a clock in the picture.")
                .must(),
            number("sigma", "unit of the column", above(0), "Scatter of one reading (standard deviation)."),
            sensor(),
        }};
}

scene::KeyTable bulk() {
    using namespace scene;
    return {.path = "bulk",
            .head = "[[bulk]]",
            .repeat = Repeat::many,
            .sentence = "Means of a bed of many bodies under one condition.",
            .keys = {
                text("name", "What to call the condition.").must(),
                words("set", {}, "Scene keys of this condition, as --set takes them: \"fill.0.count=120\".")
                    .otherwise(std::vector<std::string>{}),
                number("from_s", "s", from(0),
                       "Where averaging begins; without it the second half of the time in which walls move."),
                number("until_s", "s", above(0), "Where it ends; without it when the scene or a motion ends."),
                integer("runs", from(1, 10000), "How many runs the numbers are means of.").otherwise(std::int64_t{1}),
                flag("held_out", "Keep it for measuring the gain; it is never fitted."),
            }};
}

scene::KeyTable number_of_bulk() {
    using namespace scene;
    return {.path = "bulk.number",
            .head = "[[bulk.number]]",
            .repeat = Repeat::many,
            .required = true,
            .sentence = "One number of the bed.",
            .keys = {
                text("measure", "What it is a number of: a name of `tumble list measures`, or a column of a tracer.")
                    .must(),
                word("take", words_of_bed_takes(),
                     "Which number: the mean over time, the root mean square, the value that a tenth, half or nine "
                     "tenths of the time stays below, or the time of a cycle.")
                    .otherwise(std::string("mean")),
                number("value", "", {}, "The number, mean over all runs.").must(),
                text("unit", "Unit of value and sigma, as heads of columns have it: \"deg\", \"rad_s\"; plain numbers "
                             "have none."),
                number("sigma", "", above(0),
                       "Standard deviation from run to run; may be left out where runs is 2 or more."),
            }};
}

scene::KeyTable table() {
    using namespace scene;
    return {.path = "table",
            .head = "[[table]]",
            .repeat = Repeat::many,
            .sentence = "Single numbers of single bodies, a row for each time that the experiment ran.",
            .keys = {
                text("name", "What to call it.").must(),
                file("file", "CSV with the columns named below and those that `set` names.").must(),
                words("set", {},
                      "Scene keys of a row's experiment; {HEAD} is the row's cell under that head: "
                      "\"fill.0.position_m.1={height_m}\". Rows that set the same repeat each other.")
                    .otherwise(std::vector<std::string>{}),
                number("until_s", "s", above(0), "When the experiment ends.").must(),
                flag("held_out", "Keep it for measuring the gain; it is never fitted."),
            }};
}

scene::KeyTable column_of_table() {
    using namespace scene;
    return {.path = "table.column",
            .head = "[[table.column]]",
            .repeat = Repeat::many,
            .required = true,
            .sentence = "One column of numbers.",
            .keys = {
                text("head", "Head of the column without its unit: \"rebound\" finds rebound_m, rebound_mm.").must(),
                text("measure", "What it is a number of: a name of `tumble list measures`.").must(),
                word("take", words_of_takes(),
                     "Which number: the highest or lowest value, the last one, the mean, or rebound, the highest value "
                     "after the first lowest one.")
                    .must(),
                number("from_s", "s", from(0), "Where the stretch begins that it is taken of.").otherwise(0.0),
                number("sigma", "unit of the column", above(0),
                       "Scatter of one number (standard deviation); without it rows that repeat each other tell."),
                sensor(),
            }};
}

} // namespace

const std::vector<std::string>& words_of_takes() {
    static const std::vector<std::string> words{"highest", "lowest", "last", "mean", "rebound"};
    return words;
}

const std::vector<scene::KeyTable>& measurement_keys() {
    static const std::vector<scene::KeyTable> all{top(),  nuisance(),       series(), column(),
                                                  bulk(), number_of_bulk(), table(),  column_of_table()};
    return all;
}

} // namespace tumble::diagnose
