// SPDX-License-Identifier: GPL-3.0-or-later
// A scene that answers while somebody moves its loads and parameters.
#pragma once
#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "src/scene/scene.hpp"

namespace abut {

struct LiveOptions {
    int threads = 0;                                ///< at most; 0: one for each processor
    std::function<void(Accuracy&)> set_accuracy{};  ///< what is asked for instead of the scene's; may be empty
    std::chrono::milliseconds rest{300};            ///< after the last move the accuracy asked for is computed
    /// The drawing of a scene that was begun for one, in a file that is nobody else's. The scene's supports and loads are
    /// pointed at in the page, and it is saved beside the drawing. Empty: the scene's file is the user's, and only read.
    std::string drawing{};
};

/// What pages show is told as news: pieces of JSON, each with the serial number of its last change. Numbers that were moved get
/// a new version; the latest wins. Loads are answered at once, on the grids that are there; other geometry as a draft by a
/// thread of its own; after a rest both as accurately as was asked for, which is given up where something is moved meanwhile.
/// The scene's file is watched, and read anew where it was written. May be called from many threads.
///
/// Pieces: `controls` (what may be moved, and how far), `edges` (of the scene of a drawing, to point at), `inputs` (the numbers
/// as they are), `whole` (an analysis, as page_data has it, with its verdict), `answer` (contacts under other loads on the
/// grids of the last whole), `fields` (of that answer), `problems` (what is wrong with the scene or with what was moved; an
/// empty list: nothing).
class LiveModel {
public:
    /// Reads the scene. Throws InputError where it is wrong.
    LiveModel(const std::string& path, LiveOptions options);
    LiveModel(const LiveModel&) = delete;
    LiveModel& operator=(const LiveModel&) = delete;
    ~LiveModel();
    /// Lets everybody go who waits; nothing is computed any more.
    void stop();

    /// Takes {"client", "after", "parameters", "loads", "settings"} as JSON text: numbers that were moved, all of them or some.
    /// Returns the news after the serial number `after`, with the answer to these numbers where it takes milliseconds. Throws
    /// InputError for what is no such text, and for numbers that the scene does not have.
    std::string act(const std::string& request);
    /// The news after a serial number; waits for some as long as something is being computed, at most so long.
    std::string news(long after, std::chrono::milliseconds wait);

    /// Takes {"supports", "loads"} as a scene has them in place of those that the scene of a drawing has; what follows is news.
    /// Throws InputError where they are wrong, or where the file is the user's.
    void set_conditions(const std::string& request);

    /// Writes the scene with its numbers as they are beside its file, under the name in {"name"}: comments and all else stay.
    /// Returns {"saved": path}. Throws InputError where there is a file of that name.
    std::string save_scene(const std::string& request);
    /// The report on the numbers as they are; waits until they are answered as accurately as was asked for. Throws InputError
    /// where there is no such answer.
    std::string report();

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace abut
