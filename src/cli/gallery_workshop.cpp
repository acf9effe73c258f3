#include "cli/gallery_workshop.h"

#include "base/make_folder.h"
#include "base/remedy.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/program.h"
#include "cli/stop_flag.h"
#include "observe/whole_file.h"
#include "run/build_mark.h"

#include <chrono>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tumble::cli {

namespace fs = std::filesystem;

namespace {

/// As if it had been typed, without its results on the terminal; what is wrong is said.
int run_quietly(Words words) {
    const bool has_progress = words.front() != "lab" && words.front() != "excitation";
    if (has_progress)
        words.emplace_back("--quiet");
    words.insert(words.begin(), "tumble");
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    const SilentOutput silent;
    return run_program(static_cast<int>(pointers.size()), pointers.data());
}

bool is_stopped(int code) {
    return code == interrupted || code == terminated || code == hung_up;
}

std::string content_or_nothing(const fs::path& file) {
    const auto content = observe::read_whole(file);
    return content ? *content : "";
}

/// Runs a command, says what it does and how long it took.
int announce(const std::string& what, const Words& words) {
    note(fmt::format("{}: {}", what, typed(words)));
    const auto begun = std::chrono::steady_clock::now();
    const int code = run_quietly(words);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
    note(fmt::format("{}: {} after {}", what, is_stopped(code) ? "stopped" : (code == fine ? "done" : "failed"),
                     duration(taken.count())));
    return code;
}

} // namespace

Workshop::Workshop(fs::path out, fs::path scenes, GivenRuns given)
    : out_(std::move(out)), scenes_(std::move(scenes)), runs_(out_ / ".runs"), given_(std::move(given)) {}

int Workshop::make(const std::vector<const GalleryPicture*>& pictures) {
    if (const auto made = make_folder(runs_); !made)
        return refuse(made.problems(), false, wrong);
    clear_out_other_programs();
    std::vector<std::string> lost;
    for (const GalleryPicture* picture : pictures) {
        const End end = make(*picture);
        if (end == End::stopped) {
            note(fmt::format("the same command goes on, with what lies in {}", runs_.string()));
            return stop_code();
        }
        if (end == End::failed)
            lost.push_back(picture->file);
    }
    std::error_code ignored;
    fs::remove_all(runs_, ignored);
    say(fmt::format("{} in {}{}", counted(static_cast<long long>(pictures.size() - lost.size()), "picture", "pictures"),
                    out_.string(), lost.empty() ? "" : fmt::format("; failed: {}", fmt::join(lost, ", "))));
    return lost.empty() ? fine : failed;
}

/// What another build of the program left may hold other bits.
void Workshop::clear_out_other_programs() {
    const fs::path mark = runs_ / "build";
    if (content_or_nothing(mark) == run::build_mark())
        return;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(runs_, ignored))
        fs::remove_all(entry.path(), ignored);
    (void)observe::write_whole(mark, run::build_mark()); // without it the next call begins anew, and no more
}

Workshop::End Workshop::have_run(const GalleryRun& run) {
    if (given_.contains(run.name))
        return End::done;
    if (const auto had = runs_had_.find(run.name); had != runs_had_.end())
        return had->second;
    const fs::path folder = runs_ / run.name, over = runs_ / (run.name + ".over");
    const Words words = filled_in(run.words, {scenes_, runs_, {}, folder});
    const std::string what = "run " + run.name;
    if (content_or_nothing(over) == typed(words)) {
        note(what + ": done before");
        return runs_had_[run.name] = End::done;
    }
    int code = wrong;
    if (words.front() == "run" && fs::exists(folder)) { // broken off; refused where the table or the scene was changed
        Words again = words;
        again.emplace_back("--resume");
        code = announce(what, again);
    }
    if (code == wrong) {
        std::error_code ignored;
        fs::remove_all(folder, ignored);
        code = announce(what, words);
    }
    if (code == fine)
        (void)observe::write_whole(over, typed(words)); // without it the next call runs it again, and no more
    return runs_had_[run.name] = is_stopped(code) ? End::stopped : (code == fine ? End::done : End::failed);
}

Workshop::End Workshop::make(const GalleryPicture& picture) {
    for (const GalleryRun* run : runs_of(picture))
        if (const End end = have_run(*run); end != End::done)
            return end;
    const fs::path place = runs_ / "drawn"; // of this picture alone
    std::error_code ignored;
    fs::remove_all(place, ignored);
    if (const auto made = make_folder(place); !made) {
        refuse(made.problems(), false, failed);
        return End::failed;
    }
    const GalleryPlaces places{scenes_, runs_, place / picture.file, place / "folder", given_};
    if (!picture.words.empty()) {
        const int code = announce(picture.file, filled_in(picture.words, places));
        if (code != fine)
            return is_stopped(code) ? End::stopped : End::failed;
    }
    return keep(filled_in(picture.taken, places), picture.file) ? End::done : End::failed;
}

/// Under its name stands either the old picture or all of the new one.
bool Workshop::keep(const fs::path& made, const std::string& file) {
    const fs::path whole = runs_ / "whole";
    const auto content = observe::read_whole(made);
    const auto written = content ? observe::write_whole(whole, *content) : content.problems();
    std::error_code error;
    if (written)
        fs::rename(whole, out_ / file, error);
    if (!written)
        refuse(written.problems(), false, failed);
    else if (error)
        refuse({{.file = (out_ / file).string(),
                 .what = "cannot be written: " + error.message(),
                 .fix = remedy(error.value())}},
               false, failed);
    return written && !error;
}

} // namespace tumble::cli
