// SPDX-License-Identifier: GPL-3.0-or-later
// abut live: a scene in the browser that answers while its loads and parameters are moved.
#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <system_error>

#include "apps/accuracy_option.hpp"
#include "apps/begun_scene.hpp"
#include "apps/commands.hpp"
#include "apps/drawing_options.hpp"
#include "apps/live_server.hpp"
#include "apps/thread_option.hpp"
#include "geometry/brep/input_error.hpp"
#include "src/io/nearest_name.hpp"
#include "src/io/write_file.hpp"

namespace abut {

namespace {

int port_of(const Arguments& arguments) {
    if (!has(arguments, "--port")) return 0;
    const std::string text = arguments.options.at("--port");
    const std::optional<double> number = to_number(text);
    constexpr int most = 65535;
    if (!number || *number < 0 || *number > most || *number != static_cast<int>(*number))
        throw InputError("--port", "'" + shortened(text) + "' is no port", "give a whole number from 1 to 65535");
    return static_cast<int>(*number);
}

/// By whatever the desktop opens pages with; its own affair from then on.
void open_in_browser(const std::string& address) {
    if (fork() != 0) return;
    setsid();
    const int nothing = open("/dev/null", O_RDWR);
    for (int stream = 0; stream < 3; ++stream) dup2(nothing, stream);
    execlp("xdg-open", "xdg-open", address.c_str(), static_cast<char*>(nullptr));
    _exit(1);
}

namespace fs = std::filesystem;

/// A folder that is gone with it.
struct TemporaryFolder {
    fs::path path;
    TemporaryFolder() {
        std::string name = (fs::temp_directory_path() / "abut_live_XXXXXX").string();
        if (!mkdtemp(name.data())) throw InputError(name, "the folder cannot be made", "set TMPDIR to one that can be written");
        path = name;
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
};

/// The scene of a drawing, in a folder of its own.
std::string write_begun_scene(Arguments arguments, const fs::path& folder) {
    arguments.operand = fs::absolute(arguments.operand).lexically_normal().string();
    StarterChoice choice;
    choice.is_pointed_at = true;
    const std::string name = fs::path(arguments.operand).stem().string() + ".json";
    write_file(folder.string(), name, begun_scene(arguments, choice));
    return (folder / name).string();
}

}  // namespace

CommandSpec live_spec() {
    CommandSpec spec{
        "live",
        "FILE",
        "Shows a scene or a drawing in the browser, and answers while its loads and parameters are moved.",
        {{"--port", "N", "listen at this port of 127.0.0.1 (default: any that is free)"},
         {"--open", "", "open the page in the browser"},
         {"--accuracy", "A", "draft, standard, fine, or an error to aim at such as 0.01; instead of the scene's"},
         {"--threads", "N", "at most so many threads, with the same answer (default: one for each processor)"}},
        "Prints the page's address, which begins with a random word and is good on this machine alone, and serves it until "
        "it\n"
        "is interrupted. The tips of forces can be dragged, parts where supports let them slide; loads can be typed; "
        "parameters\n"
        "with a \"min\" and a \"max\", friction and interferences have sliders. Loads are answered at once on the grids that "
        "are\n"
        "there, all else by drafts; a moment after the last move comes what analyze would say. The scene's file is watched:\n"
        "saved in an editor, it is answered anew. Of a drawing, mesh or STEP file the page shows the edges: click those to "
        "hold\n"
        "and to load; what comes of it is saved as a scene. The options from --units on are for those files.\n"};
    for (const OptionSpec& option : begun_scene_option_specs()) spec.options.push_back(option);
    return spec;
}

int live_command(const Arguments& arguments) {
    LiveOptions options;
    options.threads = threads_of(arguments);
    options.set_accuracy = [&arguments](Accuracy& accuracy) { override_accuracy(accuracy, arguments); };
    const int port = port_of(arguments);
    std::optional<TemporaryFolder> folder;
    std::string scene = arguments.operand;
    if (kind_of_file(scene) == FileKind::drawing) {
        options.drawing = fs::absolute(scene).lexically_normal().string();
        scene = write_begun_scene(arguments, folder.emplace().path);
    } else {
        drawing_options(arguments);  // which a scene states itself
    }
    LiveModel model(scene, options);
    LiveServer server(model, port);
    std::cout << "live: " << server.address() << std::endl;  // somebody waits for this line
    if (has(arguments, "--open")) open_in_browser(server.address());
    server.run();
    return exit_done;
}

}  // namespace abut
