// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/folder_walk.hpp"

#include <algorithm>
#include <set>
#include <system_error>
#include <utility>

#include "geometry/brep/input_error.hpp"

namespace abut {

namespace {

namespace fs = std::filesystem;

class Walk {
public:
    explicit Walk(const std::function<bool(const fs::path&)>& passed_over) : passed_over_(passed_over) {}

    FolderFiles from(const fs::path& folder) {
        std::error_code error;
        const fs::directory_iterator first(folder, error);
        if (error) throw InputError(folder.string(), "the folder cannot be read: " + error.message(), "check its permissions");
        look_into(folder);
        while (!links_.empty()) follow(links_.extract(links_.begin()).value());
        return std::move(found_);
    }

private:
    /// Real folders at once, links to folders later: where a folder is counts before where it is linked.
    void look_into(const fs::path& folder) {
        std::error_code error;
        if (!seen_.insert(fs::canonical(folder, error)).second) return;
        fs::directory_iterator entry(folder, error);
        if (error) found_.left_out.push_back(folder.string() + ": " + error.message());
        for (const fs::directory_iterator end; !error && entry != end; entry.increment(error)) take(*entry);
    }

    void take(const fs::directory_entry& entry) {
        std::error_code error;
        if (!entry.is_directory(error)) {
            if (!entry.path().filename().string().starts_with(".")) found_.files.push_back(entry.path());
        } else if (!passed_over_(entry.path())) {
            if (entry.is_symlink(error))
                links_.insert(entry.path());
            else
                look_into(entry.path());
        }
    }

    void follow(const fs::path& link) {
        std::error_code error;
        const fs::path target = fs::canonical(link, error), place = fs::canonical(link.parent_path(), error);
        if (is_within(place, target))
            found_.left_out.push_back(link.string() + ": a link to a folder that it lies in");
        else if (seen_.contains(target))
            found_.left_out.push_back(link.string() + ": a link to " + target.string() + ", whose files are jobs already");
        else
            look_into(link);
    }

    static bool is_within(const fs::path& path, const fs::path& folder) {
        return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
    }

    const std::function<bool(const fs::path&)>& passed_over_;
    std::set<fs::path> seen_;   // real places
    std::set<fs::path> links_;  // to folders, not followed yet
    FolderFiles found_;
};

}  // namespace

FolderFiles files_below(const std::string& folder, const std::function<bool(const fs::path&)>& passed_over) {
    return Walk(passed_over).from(folder);
}

}  // namespace abut
