// SPDX-License-Identifier: GPL-3.0-or-later
// What `abut live` serves: one page and its news, to this machine alone.
#pragma once
#include <memory>
#include <string>

#include "src/live/live_model.hpp"

namespace abut {

/// A server of one model's page on 127.0.0.1. Its address begins with a random word; requests for any other, or under another
/// name of the machine, are told nothing. Requests are limited in size and in time, connections in number.
///
/// Below the address: GET "" (the page), GET "news?after=N" and POST "act" (LiveModel), POST "save" (a scene), GET "report" (a
/// page by itself). What is wrong with a request is a list of problems with status 400.
class LiveServer {
public:
    /// Takes the port; 0: any that is free. Throws InputError where it is taken.
    LiveServer(LiveModel& model, int port);
    LiveServer(const LiveServer&) = delete;
    LiveServer& operator=(const LiveServer&) = delete;
    ~LiveServer();

    std::string address() const;
    /// Serves until the process is interrupted or told to end.
    void run();

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace abut
