// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/body_names.hpp"

namespace abut::geometry {

std::string BodyNames::next(const std::string& base, bool is_one_of_several) {
    std::string name;
    do {
        if (base.empty()) {
            name = unnamed_ + std::to_string(++n_unnamed_);
            continue;
        }
        const int k = n_of_name_[base]++;
        name = k == 0 && !is_one_of_several ? base : base + "#" + std::to_string(k);
    } while (!names_.insert(name).second);
    return name;
}

}  // namespace abut::geometry
