// Stands in for libFuzzer's main function where there is none: calls the target with the files that are
// named, and with those in the folders that are named, each in a process of its own.
//   TARGET FILE_OR_FOLDER...
#include <sys/wait.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <vector>

#include "fuzz/targets/target.hpp"

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_in(const fs::path& place) {
    if (!fs::is_directory(place)) return {place};
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(place)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

/// @return whether there is a file, and the target takes its bytes.
bool takes(const fs::path& path) {
    if (!fs::is_regular_file(path)) {
        std::fprintf(stderr, "%s: there is no such file\n", path.c_str());
        return false;
    }
    const pid_t child = ::fork();
    if (child == 0) {
        std::ifstream file(path, std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(file), {}};
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
        rockslope::fuzz::remove_files();
        ::_exit(0);
    }
    int status = -1;
    ::waitpid(child, &status, 0);
    if (status == 0) return true;
    std::fprintf(stderr, "%s: ended with status %d\n", path.c_str(), status);
    return false;
}

}  // namespace

int main(int argc, char** argv) {
    bool good = true;
    int count = 0;
    for (int k = 1; k < argc; ++k) {
        for (const fs::path& path : files_in(argv[k])) {
            good = takes(path) && good;
            ++count;
        }
    }
    std::printf("%d inputs\n", count);
    return good && count > 0 ? 0 : 1;
}
