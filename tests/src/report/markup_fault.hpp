// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a page's markup holds together.
#pragma once
#include <algorithm>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace abut {

/// The page without what stands in its scripts.
inline std::string without_scripts(std::string page) {
    for (std::size_t at = page.find("<script"); at != std::string::npos; at = page.find("<script", at + 1)) {
        const std::size_t begin = page.find('>', at) + 1;
        page.erase(begin, page.find("</script>", begin) - begin);
    }
    return page;
}

/// What is wrong with the markup, "" if nothing: every element is closed in its turn (the report is written so that it is
/// well-formed XML as well as HTML), ids are unique, and references point at them.
inline std::string fault(const std::string& whole_page) {
    const std::string page = without_scripts(whole_page);
    std::vector<std::string> open;
    for (std::size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at + 1)) {
        if (page.compare(at, 2, "<!") == 0) continue;
        const std::size_t end = page.find('>', at);
        if (end == std::string::npos) return "unfinished tag";
        const std::string tag = page.substr(at + 1, end - at - 1);
        if (tag.find('<') != std::string::npos) return "stray <: " + tag;
        if (std::count(tag.begin(), tag.end(), '"') % 2) return "odd quotes: " + tag;
        const std::string name = tag.substr(tag[0] == '/' ? 1 : 0, tag.find_first_of(" /", 1) - (tag[0] == '/' ? 1 : 0));
        if (tag[0] == '/') {
            if (open.empty() || open.back() != name)
                return "closes " + name + " inside " + (open.empty() ? "nothing" : open.back());
            open.pop_back();
        } else if (tag.back() != '/') {
            open.push_back(name);
        }
    }
    if (!open.empty()) return "not closed: " + open.back();
    std::set<std::string> ids;
    const std::regex id(" id=\"([^\"]*)\""), reference("url\\(#([^)]*)\\)");
    for (std::sregex_iterator i(page.begin(), page.end(), id), none; i != none; ++i)
        if (!ids.insert((*i)[1]).second) return "id twice: " + (*i)[1].str();
    for (std::sregex_iterator i(page.begin(), page.end(), reference), none; i != none; ++i)
        if (!ids.count((*i)[1])) return "no such id: " + (*i)[1].str();
    return "";
}

}  // namespace abut
