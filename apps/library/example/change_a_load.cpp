// SPDX-License-Identifier: GPL-3.0-or-later
// How the contact of a scene grows with one of its loads: change_a_load SCENE LOAD
#include <iostream>

#include "geometry/brep/input_error.hpp"
#include "src/session/session.hpp"

int main(int, char** words) try {
    abut::Session session(words[1]);
    session.prepare();
    for (double factor = 0.5; factor <= 1.5; factor += 0.25) {
        session.set_load(words[2], factor);
        const abut::Answer answer = session.answer();
        std::cout << words[2] << " times " << factor << ": " << answer.status << " " << answer.message << "\n";
        for (const abut::ContactAnswer& contact : answer.contacts)
            std::cout << "  " << contact.parts[0] << " - " << contact.parts[1] << ": " << contact.max_pressure.value << " over "
                      << contact.contact_length << "\n";
        for (const std::string& doubt : answer.doubts) std::cout << "  doubt: " << doubt << "\n";
    }
} catch (const abut::InputError& error) {
    std::cerr << error.what() << "\n";
    return 2;
}
