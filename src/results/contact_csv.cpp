// SPDX-License-Identifier: GPL-3.0-or-later

#include "src/io/csv_field.hpp"
#include "src/results/result.hpp"

namespace abut {

std::string contact_csv(const ContactResult& contact) {
    const ContactProfile& p = contact.profile;
    std::string text = "edge,s,x,y,pressure,gap\n";
    for (std::size_t i = 0; i < p.s.size(); ++i) {
        text += csv_field(p.edge[i]);
        for (double value : {p.s[i], p.x[i], p.y[i], p.pressure[i], p.gap[i]}) text += "," + csv_field(value);
        text += "\n";
    }
    return text;
}

}  // namespace abut
