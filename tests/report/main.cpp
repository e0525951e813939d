// Writes the verification report of the documentation from the rows and pictures that the verification tests
// recorded, or checks that the committed report agrees with them.

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>

#include "report/page.hpp"
#include "report/pictures.hpp"

using namespace rockslope;

namespace {

namespace fs = std::filesystem;
using namespace verification;

constexpr const char* usage =
    "verification_table write ROWS DOCS   make DOCS/verification.md, .tsv and pictures from the rows in "
    "ROWS\n"
    "verification_table check ROWS DOCS   exit code 1 if a row is outside or DOCS does not agree with these "
    "rows\n";

std::vector<Row> recorded_rows(const fs::path& folder) {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".tsv") paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    std::vector<Row> rows;
    for (const fs::path& path : paths) {
        const std::vector<Row> more = read_rows(path.string());
        rows.insert(rows.end(), more.begin(), more.end());
    }
    return in_order(std::move(rows));
}

std::string picture_path(const std::string& stem) {
    return "verification/" + stem + ".svg";
}

void write_file(const fs::path& path, const std::string& text) {
    std::ofstream out(path, std::ios::binary);
    out << text;
    if (!out.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

std::string contents(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) throw std::runtime_error(path.string() + ": cannot be read");
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::vector<PictureLink> links(const std::vector<Picture>& pictures) {
    std::vector<PictureLink> made;
    for (const Picture& picture : pictures)
        made.push_back({picture.id, picture_path(picture.stem), picture.title});
    return made;
}

int write_report(const fs::path& recorded, const fs::path& docs) {
    const std::vector<Row> rows = recorded_rows(recorded);
    const std::vector<Picture> pictures = read_pictures(recorded.string());
    fs::remove_all(docs / "verification");
    fs::create_directories(docs / "verification");
    for (const Picture& picture : pictures) write_file(docs / picture_path(picture.stem), draw(picture));
    std::ostringstream table;
    write_header(table);
    for (const Row& row : rows) write_row(table, row);
    write_file(docs / "verification.tsv", table.str());
    write_file(docs / "verification.md", page(rows, links(pictures)));
    std::printf("%zu rows, %zu pictures in %s\n", rows.size(), pictures.size(), docs.string().c_str());
    return 0;
}

int check_report(const fs::path& recorded, const fs::path& docs) {
    const std::vector<Row> fresh = recorded_rows(recorded);
    const std::vector<Row> committed = read_rows((docs / "verification.tsv").string());
    std::vector<std::string> faults = differences(committed, fresh);
    for (const std::string& fault : missing_balances(fresh)) faults.push_back(fault);
    for (const Row& row : fresh) {
        if (row.verdict == Verdict::fails)
            faults.push_back(row.id + ", " + row.set_up + ", " + row.quantity + ": outside its tolerance");
    }
    const std::vector<PictureLink> pictures = links(read_pictures(recorded.string()));
    for (const PictureLink& picture : pictures) {
        if (!fs::exists(docs / picture.path)) faults.push_back(picture.path + ": missing");
    }
    if (faults.empty() && contents(docs / "verification.md") != page(in_order(committed), pictures))
        faults.emplace_back("verification.md does not agree with verification.tsv");
    for (const std::string& fault : faults) std::fprintf(stderr, "%s\n", fault.c_str());
    if (!faults.empty())
        std::fprintf(stderr,
                     "cmake --build --preset release --target verification_report writes the report again\n");
    return faults.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string command = argc == 4 ? argv[1] : "";
    if (command != "write" && command != "check") {
        std::fputs(usage, stderr);
        return 2;
    }
    try {
        return command == "write" ? write_report(argv[2], argv[3]) : check_report(argv[2], argv[3]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "verification_table: %s\n", error.what());
        return 2;
    }
}
