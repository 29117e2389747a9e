// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/batch/job_store.hpp"

#include <fcntl.h>
#include <linux/fs.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "src/io/temporary_file.hpp"
#include "src/io/whole_file.hpp"

namespace abut {

namespace {

namespace fs = std::filesystem;

constexpr const char* run_prefix = ".run-";
constexpr const char* lock_ending = ".lock";

[[noreturn]] void give_up(const fs::path& path, const std::string& reason) {
    throw StoreError(path.string() + " cannot be written: " + reason);
}

void make_folders(const fs::path& path) {
    std::error_code error;
    fs::create_directories(path, error);
    if (error) give_up(path, error.message());
}

constexpr int lock_attempts = 200;
constexpr useconds_t lock_pause = 5000;  // microseconds

/// The file with this name, locked, or -1: someone else has the lock, or has just removed the file.
int locked_file(const std::string& path, int flags) {
    const int file = ::open(path.c_str(), flags | O_RDWR | O_CLOEXEC, 0666);
    if (file < 0) return -1;
    struct stat opened {
    }, named{};
    if (::flock(file, LOCK_EX | LOCK_NB) == 0 && ::fstat(file, &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
        opened.st_ino == named.st_ino)
        return file;
    ::close(file);
    return -1;
}

/// The folders of runs whose process is gone, and the files that they were writing. Their lock file goes last, so that nothing
/// is left if this process dies too.
void remove_left_overs(const std::string& out) {
    remove_abandoned(out);
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(out, error)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with(run_prefix) || !name.ends_with(lock_ending)) continue;
        const int lock = locked_file(entry.path().string(), 0);
        if (lock < 0) continue;
        std::error_code ignored;
        fs::remove_all(entry.path().parent_path() / fs::path(name).stem(), ignored);
        fs::remove(entry.path(), ignored);
        ::close(lock);
    }
}

/// Two folders change names in one step; false where the file system cannot do that.
bool exchange(const fs::path& a, const fs::path& b) {
    return ::renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0;
}

}  // namespace

JobStore::JobStore(std::string out) : out_(std::move(out)) {
    make_folders(fs::path(out_) / "jobs");
    remove_left_overs(out_);
    run_ = (fs::path(out_) / (run_prefix + host_name() + "-" + std::to_string(::getpid()))).string();
    // another process that tidies up may take the new file for a left over: then it is made again
    for (int attempt = 0; attempt < lock_attempts; ++attempt) {
        errno = 0;
        lock_ = locked_file(run_ + lock_ending, O_CREAT);
        if (lock_ >= 0 || errno == EACCES || errno == ENOSPC || errno == EROFS || errno == ENOLCK) break;
        ::usleep(lock_pause);
    }
    if (lock_ < 0) give_up(run_ + lock_ending, errno != 0 ? std::strerror(errno) : "it is locked");
    make_folders(run_);
}

JobStore::~JobStore() {
    std::error_code ignored;
    fs::remove_all(run_, ignored);
    fs::remove(run_ + lock_ending, ignored);
    ::close(lock_);
    remove_left_overs(out_);  // again: the last workers of a killed run may have died after this one had begun
}

std::string JobStore::begin(const std::string& name) const {
    drop(name);
    make_folders(begun(name));
    return begun(name);
}

std::string JobStore::begun(const std::string& name) const {
    return (fs::path(run_) / name).string();
}

void JobStore::finish(const std::string& name) const {
    const fs::path made = fs::path(run_) / name, place = job_folder(out_, name);
    std::error_code error;
    fs::rename(made, place, error);
    if (!error) return;
    if (!fs::is_directory(place)) give_up(place, error.message());
    if (exchange(made, place)) return drop(name);
    // Killed between these two, the job is simply not there and will be done again.
    fs::remove_all(place, error);
    fs::rename(made, place, error);
    if (error) give_up(place, error.message());
}

void JobStore::drop(const std::string& name) const {
    std::error_code error;
    fs::remove_all(fs::path(run_) / name, error);
    if (error) give_up(fs::path(run_) / name, error.message());
}

std::string job_folder(const std::string& out, const std::string& name) {
    return (fs::path(out) / "jobs" / name).string();
}

std::optional<JobRecord> stored_job(const std::string& out, const std::string& name) {
    const fs::path folder = job_folder(out, name);
    const std::optional<std::string> text = whole_file((folder / "job.json").string());
    std::optional<JobRecord> record = text ? parse_job_json(*text) : std::nullopt;
    if (!record || record->name != name) return std::nullopt;
    std::error_code error;
    if (record->files.size() != record->sizes.size()) return std::nullopt;
    for (std::size_t i = 0; i < record->files.size(); ++i)
        if (fs::file_size(folder / record->files[i], error) != record->sizes[i] || error) return std::nullopt;
    return record;
}

}  // namespace abut
