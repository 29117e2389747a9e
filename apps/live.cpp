// SPDX-License-Identifier: GPL-3.0-or-later
// abut live: a scene in the browser that answers while its loads and parameters are moved.
#include <fcntl.h>
#include <unistd.h>

#include <iostream>

#include "apps/accuracy_option.hpp"
#include "apps/commands.hpp"
#include "apps/live_server.hpp"
#include "apps/thread_option.hpp"
#include "geometry/brep/input_error.hpp"
#include "src/io/nearest_name.hpp"

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

}  // namespace

CommandSpec live_spec() {
    return {
        "live",
        "SCENE",
        "Shows a scene in the browser, and answers while its loads and parameters are moved.",
        {{"--port", "N", "listen at this port of 127.0.0.1 (default: any that is free)"},
         {"--open", "", "open the page in the browser"},
         {"--accuracy", "A", "draft, standard, fine, or an error to aim at such as 0.01; instead of the scene's"},
         {"--threads", "N", "at most so many threads, with the same answer (default: one for each processor)"}},
        "Prints the page's address, which begins with a random word and is good on this machine alone, and serves it until "
        "it\n"
        "is interrupted. The tips of forces can be dragged; loads can be typed; parameters with a \"min\" and a \"max\" have\n"
        "sliders. Loads are answered at once on the grids that are there, other geometry by drafts; a moment after the last\n"
        "move comes what analyze would say. The scene's file is watched: saved in an editor, it is answered anew.\n"};
}

int live_command(const Arguments& arguments) {
    LiveOptions options;
    options.threads = threads_of(arguments);
    options.set_accuracy = [&arguments](Accuracy& accuracy) { override_accuracy(accuracy, arguments); };
    const int port = port_of(arguments);
    LiveModel model(arguments.operand, options);
    LiveServer server(model, port);
    std::cout << "live: " << server.address() << std::endl;  // somebody waits for this line
    if (has(arguments, "--open")) open_in_browser(server.address());
    server.run();
    return exit_done;
}

}  // namespace abut
