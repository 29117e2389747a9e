// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/live/live_model.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "geometry/brep/input_error.hpp"
#include "solver/linear_algebra/blas_threads.hpp"
#include "src/io/file_stamp.hpp"
#include "src/io/json_edit.hpp"
#include "src/io/whole_file.hpp"
#include "src/io/write_file.hpp"
#include "src/live/live_json.hpp"
#include "src/live/live_loads.hpp"
#include "src/plan/boundary_conditions.hpp"
#include "src/plan/model_facts_of.hpp"
#include "src/report/report.hpp"
#include "src/scene/accuracy_goal.hpp"
#include "src/scene/load_cases.hpp"
#include "src/scene/read_scene.hpp"
#include "src/session/prepared_scene.hpp"

namespace abut {

namespace {

using LiveClock = std::chrono::steady_clock;

/// How often the scene's file is looked at, and the thread looks around.
constexpr std::chrono::milliseconds live_tick{50};
/// Fields may take this share of the time, so that answers never wait for long.
constexpr double fields_share = 0.5;

/// Numbers were moved while an analysis went on: nobody waits for it any more.
struct GivenUp {};

/// A scene as a file and the numbers of its parameters make it.
struct DrawnScene {
    Scene scene;
    ModelSources sources;
    LiveControls controls;
};

DrawnScene read_drawn(const std::string& path, const std::map<std::string, double>& parameters,
                      const std::function<void(Accuracy&)>& set_accuracy) {
    DrawnScene drawn;
    drawn.controls.parameters = parameter_ranges(path);
    drawn.scene = read_scene(path, parameters);
    drawn.sources = model_sources(drawn.scene);
    if (set_accuracy) set_accuracy(drawn.scene.accuracy);
    drawn.controls.loads = model_facts(drawn.scene, drawn.sources).loads;
    drawn.controls.target = target_of(drawn.scene.accuracy);
    drawn.controls.remembers = drawn.scene.in_steps;
    return drawn;
}

/// An analysis that answers other loads. `lock` is held for whatever asks the prepared scene.
struct PreparedLive {
    std::mutex lock;
    DrawnScene drawn;
    LiveInputs inputs;
    bool is_draft;
    Result result;  ///< of `prepared`, with the marks of its scene's own loads
    std::optional<PreparedScene> prepared;

    PreparedLive(DrawnScene from, LiveInputs under, bool draft, const AnalyzeOptions& options)
        : drawn(std::move(from)), inputs(std::move(under)), is_draft(draft) {
        Scene units = with_unit_loads(drawn.scene);
        if (is_draft && target_of(units.accuracy) < draft_target) units.accuracy.target = draft_target;
        prepared.emplace(units, unit_factors(drawn.scene, inputs), options);
        result = prepared->result();
        Scene others = scene_under(drawn.scene, inputs);  // the page draws forces itself
        std::erase_if(others.loads, is_live_force);
        result.load_marks = load_marks(others, resolve_conditions(others));
    }

    bool answers(const LiveInputs& other) const {
        return other.parameters == inputs.parameters && other.settings == inputs.settings &&
               prepared->needs_preparing(unit_factors(drawn.scene, other)).empty();
    }
    ModelFacts facts() const { return model_facts(scene_under(drawn.scene, inputs), drawn.sources); }
};

/// Pairs that were known keep their settings where they don't touch at the moment.
void keep_pairs(const std::vector<LiveSetting>& before, std::vector<LiveSetting>& settings) {
    for (const LiveSetting& old : before) {
        const auto is_old = [&](const LiveSetting& s) { return s.key == old.key; };
        if (old.kind == LiveSetting::Kind::pair && std::none_of(settings.begin(), settings.end(), is_old))
            settings.push_back(old);
    }
}

struct LivePiece {
    long serial = 0;
    std::string text;
};

}  // namespace

struct LiveModel::State {
    std::string path;
    LiveOptions options;

    std::mutex lock;  // of all below; taken before a prepared scene's own lock is, never after
    std::condition_variable changed;
    bool stops = false;
    DrawnScene drawn;
    FileStamp stamp;
    LiveInputs inputs;
    long version = 1, serial = 0;
    std::map<std::string, LivePiece> pieces;
    std::string busy;  // "draft", "accuracy", or nothing
    std::shared_ptr<PreparedLive> prepared;
    /// The versions that were answered, whose fields are known, that were answered as accurately as asked, and that failed.
    long answered = 0, with_fields = 0, settled = 0, refused = 0;
    LiveClock::time_point moved = LiveClock::now(), next_fields = moved;
    std::atomic<long> newest = 1;  // the version, for those who don't hold the lock; 0: the end
    std::mutex computing;          // held by whoever computes, where the linear algebra library is for one thread alone
    const bool one_at_a_time = solver::usable_threads(2) == 1;
    std::thread worker;

    void publish(const std::string& name, std::string text) {
        pieces[name] = {++serial, std::move(text)};
        changed.notify_all();
    }
    void take_inputs(LiveInputs moved_to, const std::string& client) {
        inputs = std::move(moved_to);
        newest = ++version;
        moved = LiveClock::now();
        publish("inputs", inputs_json(inputs, client, version));
    }
    void take_drawn(DrawnScene read);
    void take_settings(PreparedLive& made);
    std::string news_after(long after) const;
    std::unique_lock<std::mutex> alone() {
        return one_at_a_time ? std::unique_lock(computing) : std::unique_lock<std::mutex>();
    }
    Answer answer_of(PreparedLive& from, const LiveInputs& to) {
        const auto own = alone();
        const std::lock_guard<std::mutex> hold(from.lock);
        return from.prepared->answer(unit_factors(from.drawn.scene, to));
    }

    // The worker's; each is called with the lock held, and lets go of it while it computes.
    using Hold = std::unique_lock<std::mutex>;
    void work();
    void read_again(Hold& hold);
    void analyse(Hold& hold, bool is_draft);
    void answer(Hold& hold);
    void find_fields(Hold& hold);
    void refuse(long of_version, const std::vector<Problem>& problems) {
        refused = std::max(refused, of_version);
        publish("problems", problems_json(problems));
    }
};

void LiveModel::State::take_drawn(DrawnScene read) {
    const std::vector<LiveSetting> before = std::move(drawn.controls.settings);
    drawn = std::move(read);
    drawn.controls.settings = live_settings(drawn.scene, {});
    LiveInputs given{{}, live_loads(drawn.scene)};
    if (!drawn.scene.cases.empty()) given.loads = live_loads(drawn.scene, drawn.scene.cases.front());
    for (const ParameterRange& p : drawn.controls.parameters) given.parameters[p.name] = p.value;
    prepared = nullptr;
    if (!options.drawing.empty()) {  // what is pointed at changes neither parts nor contacts
        given.settings = inputs.settings;
        keep_pairs(before, drawn.controls.settings);
        publish("edges", edges_json(drawn.scene, read_whole_file(path)));
    }
    publish("controls", controls_json(drawn.scene, drawn.controls));
    take_inputs(std::move(given), "");
}

/// Contacts that were found have settings.
void LiveModel::State::take_settings(PreparedLive& made) {
    std::vector<LiveSetting> found = live_settings(drawn.scene, made.result.contacts);
    keep_pairs(drawn.controls.settings, found);
    made.drawn.controls.settings = drawn.controls.settings = std::move(found);
}

std::string LiveModel::State::news_after(long after) const {
    std::string text = "{\"serial\":" + std::to_string(serial) + ",\"version\":" + std::to_string(version) + ",\"busy\":\"" +
                       busy + "\",\"settled\":" + (settled == version ? "true" : "false") + ",\"pieces\":{";
    bool is_first = true;
    for (const auto& [name, piece] : pieces) {
        if (piece.serial <= after) continue;
        text += (is_first ? "\"" : ",\"") + name + "\":" + piece.text;
        is_first = false;
    }
    return text + "}}";
}

void LiveModel::State::work() {
    Hold hold(lock);
    while (!stops) {
        const auto now = LiveClock::now();
        if (file_stamp(path) != stamp)
            read_again(hold);
        else if (refused == version)
            changed.wait_for(hold, live_tick);  // NOLINT(bugprone-branch-clone): what is refused waits before all else
        else if (!prepared || !prepared->answers(inputs))
            analyse(hold, true);
        else if (answered != version)
            answer(hold);
        else if (with_fields != version && now >= next_fields)
            find_fields(hold);
        else if (settled != version && now >= moved + options.rest)
            analyse(hold, false);
        else
            changed.wait_for(hold, live_tick);
    }
}

void LiveModel::State::read_again(Hold& hold) {
    const FileStamp seen = file_stamp(path);
    changed.wait_for(hold, live_tick);
    if (file_stamp(path) != seen) return;  // who writes it is not done
    stamp = seen;
    hold.unlock();
    std::optional<DrawnScene> read;
    std::vector<Problem> problems;
    try {
        read = read_drawn(path, {}, options.set_accuracy);
    } catch (const InputError& error) { problems = error.problems(); }
    hold.lock();
    if (read) return take_drawn(std::move(*read));
    newest = ++version;
    refuse(version, problems);
}

void LiveModel::State::analyse(Hold& hold, bool is_draft) {
    const long of_version = version;
    const LiveInputs under = inputs;
    DrawnScene now = drawn;
    busy = is_draft ? "draft" : "accuracy";
    changed.notify_all();
    hold.unlock();
    AnalyzeOptions analyze_options;
    analyze_options.threads = options.threads;
    analyze_options.progress = [&](const std::string&) {
        if (newest == 0 || (!is_draft && newest != of_version)) throw GivenUp();
    };
    std::shared_ptr<PreparedLive> made;
    std::vector<Problem> problems;
    std::string whole;
    try {
        const auto own = alone();
        const std::vector<LiveSetting> settings = now.controls.settings;
        if (!under.parameters.empty()) now = read_drawn(path, under.parameters, options.set_accuracy);
        if (!under.settings.empty()) {
            now.scene = with_settings(std::move(now.scene), settings, under.settings);
            now.controls.loads = model_facts(now.scene, now.sources).loads;
        }
        made = std::make_shared<PreparedLive>(std::move(now), under, is_draft, analyze_options);
        whole = whole_json(made->result, made->facts(), is_draft, under.settings, of_version);
    } catch (const GivenUp&) {
    } catch (const InputError& error) { problems = error.problems(); } catch (const std::exception& error) {
        problems = {{path, std::string("an error in the program itself: ") + error.what(), "please report it with the file"}};
    }
    hold.lock();
    busy.clear();
    changed.notify_all();
    if (!problems.empty()) return refuse(of_version, problems);
    if (!made || file_stamp(path) != stamp) return;
    prepared = made;
    take_settings(*made);
    publish("controls", controls_json(made->drawn.scene, made->drawn.controls));  // where loads act goes with the geometry
    publish("whole", whole);
    publish("problems", problems_json({}));
    pieces.erase("answer");
    pieces.erase("fields");
    answered = with_fields = of_version;
    const bool is_as_asked = !is_draft || target_of(made->drawn.scene.accuracy) >= draft_target;
    if (is_as_asked) settled = of_version;
}

void LiveModel::State::answer(Hold& hold) {
    const long of_version = version;
    const LiveInputs to = inputs;
    const std::shared_ptr<PreparedLive> from = prepared;
    hold.unlock();
    const std::string text = answer_json(answer_of(*from, to), of_version);
    hold.lock();
    if (prepared != from || answered >= of_version) return;
    answered = of_version;
    publish("answer", text);
}

void LiveModel::State::find_fields(Hold& hold) {
    const long of_version = version;
    const LiveInputs to = inputs;
    const std::shared_ptr<PreparedLive> from = prepared;
    hold.unlock();
    const auto begin = LiveClock::now();
    std::optional<std::vector<PartField>> fields;
    {
        const auto own = alone();
        const std::lock_guard<std::mutex> prepared_one(from->lock);
        if (from->prepared->answer(unit_factors(from->drawn.scene, to)).status == "ok") fields = from->prepared->fields();
    }
    const std::string text = fields ? fields_json(from->result, *fields, of_version) : "";
    const auto took = LiveClock::now() - begin;
    hold.lock();
    next_fields = LiveClock::now() + std::chrono::duration_cast<LiveClock::duration>(took * (1 / fields_share - 1));
    if (prepared != from) return;
    with_fields = of_version;
    if (!text.empty()) publish("fields", text);
}

LiveModel::LiveModel(const std::string& path, LiveOptions options) : state_(std::make_unique<State>()) {
    State& s = *state_;
    s.path = path;
    s.options = std::move(options);
    s.stamp = file_stamp(path);
    s.take_drawn(read_drawn(path, {}, s.options.set_accuracy));
    s.worker = std::thread([&s] { s.work(); });
}

LiveModel::~LiveModel() {
    stop();
    state_->worker.join();
}

void LiveModel::stop() {
    const std::lock_guard<std::mutex> hold(state_->lock);
    state_->stops = true;
    state_->newest = 0;
    state_->changed.notify_all();
}

std::string LiveModel::act(const std::string& text) {
    State& s = *state_;
    State::Hold hold(s.lock);
    const LiveRequest request = read_live_request(text, s.drawn.scene, s.drawn.controls, s.inputs);
    if (request.inputs != s.inputs) s.take_inputs(request.inputs, request.client);
    const std::shared_ptr<PreparedLive> from = s.prepared;
    if (!from || s.answered == s.version || s.refused == s.version || !from->answers(request.inputs))
        return s.news_after(request.after);
    const long of_version = s.version;
    hold.unlock();
    const std::string answer = answer_json(s.answer_of(*from, request.inputs), of_version);
    hold.lock();
    if (s.prepared == from && s.answered < of_version) {
        s.answered = of_version;
        s.publish("answer", answer);
        return s.news_after(request.after);
    }
    // Somebody else has moved on meanwhile: the answer to these numbers goes with the news all the same.
    const auto kept = s.pieces.find("answer");
    const std::optional<LivePiece> newer = kept == s.pieces.end() ? std::nullopt : std::optional(kept->second);
    s.pieces["answer"] = {s.serial + 1, answer};
    const std::string news = s.news_after(request.after);
    if (newer)
        s.pieces["answer"] = *newer;
    else
        s.pieces.erase("answer");
    return news;
}

std::string LiveModel::news(long after, std::chrono::milliseconds wait) {
    State& s = *state_;
    State::Hold hold(s.lock);
    const auto is_news = [&] { return s.stops || s.serial > after; };
    const bool is_at_work =
        !s.busy.empty() || (s.refused != s.version && (s.answered != s.version || s.with_fields != s.version));
    if (is_at_work) s.changed.wait_for(hold, wait, is_news);
    return s.news_after(after);
}

void LiveModel::set_conditions(const std::string& request) {
    State& s = *state_;
    if (s.options.drawing.empty())
        throw InputError(s.path, "supports and loads are pointed at for drawings alone", "write them into the scene's file");
    const std::string text = with_values(read_whole_file(s.path), read_conditions_request(request));
    read_scene_text(text, s.path);  // throws where they are wrong
    const std::filesystem::path file(s.path);
    write_file(file.parent_path().string(), file.filename().string(), text);
}

std::string LiveModel::save_scene(const std::string& request) {
    State& s = *state_;
    const std::string name = read_save_request(request);
    State::Hold hold(s.lock);
    if (!s.drawn.scene.cases.empty())
        throw InputError(s.path, "the scene has " + case_word(s.drawn.scene) + "s, which are factors of its loads",
                         "change the factors in the file");
    std::string text = scene_text_with(read_whole_file(s.path), s.drawn.scene, s.drawn.controls, s.inputs);
    hold.unlock();
    const bool is_of_drawing = !s.options.drawing.empty();
    const std::filesystem::path home = is_of_drawing ? s.options.drawing : s.path, folder = home.parent_path();
    if (is_of_drawing) text = with_values(text, {{"/assembly/file", json_text(home.filename().string())}});
    if (std::filesystem::exists(folder / name))
        throw InputError((folder / name).string(), "is there already", "give another name");
    write_file(folder.string(), name, text);
    return saved_json((folder / name).string());
}

std::string LiveModel::report() {
    State& s = *state_;
    State::Hold hold(s.lock);
    const auto is_ready = [&] { return s.stops || s.settled == s.version || s.refused == s.version; };
    s.changed.wait_for(hold, std::chrono::minutes(2), is_ready);
    if (s.settled != s.version || !s.prepared)
        throw InputError(s.path, "there is no answer to report on", "wait for the answer, and mend what is wrong");
    const std::shared_ptr<PreparedLive> from = s.prepared;
    hold.unlock();
    return report_html(from->result, from->facts());
}

}  // namespace abut
