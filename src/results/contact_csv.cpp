// SPDX-License-Identifier: GPL-3.0-or-later

#include "src/io/csv_field.hpp"
#include "src/results/result.hpp"

namespace abut {

std::string contact_csv(const ContactResult& contact) {
    const ContactProfile& p = contact.profile;
    const bool has_friction = !p.slip.empty();
    std::string text = "edge,s,x,y,pressure,gap" + std::string(has_friction ? ",shear,slip,state\n" : "\n");
    for (std::size_t i = 0; i < p.s.size(); ++i) {
        text += csv_field(p.edge[i]);
        for (double value : {p.s[i], p.x[i], p.y[i], p.pressure[i], p.gap[i]}) text += "," + csv_field(value);
        if (has_friction) text += "," + csv_field(p.shear[i]) + "," + csv_field(p.slip[i]) + "," + csv_field(p.state[i]);
        text += "\n";
    }
    return text;
}

}  // namespace abut
