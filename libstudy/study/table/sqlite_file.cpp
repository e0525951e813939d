#include "study/table/sqlite_file.hpp"

#include <sqlite3.h>

#include <memory>
#include <utility>

#include "common/base/atomic_file.hpp"
#include "common/base/output_error.hpp"
#include "common/base/text.hpp"

namespace rockslope::study {

namespace fs = std::filesystem;

namespace {

/// A name as SQL quotes it.
std::string sql_name(const std::string& name) {
    std::string text = "\"";
    for (const char c : name) text += c == '"' ? std::string("\"\"") : std::string(1, c);
    return text + '"';
}

class Database {
  public:
    /// Opens an empty file, which nobody misses when it is spoilt: it needs no journal. @param shown in
    /// messages.
    Database(const fs::path& file, fs::path shown) : file_(std::move(shown)) {
        check(
            ::sqlite3_open_v2(file.c_str(), &handle_, SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOFOLLOW, nullptr));
        execute("PRAGMA journal_mode = OFF");
    }
    ~Database() { ::sqlite3_close(handle_); }
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    void execute(const std::string& statement) {
        check(::sqlite3_exec(handle_, statement.c_str(), nullptr, nullptr, nullptr));
    }
    void insert(const std::string& statement, const std::vector<std::vector<std::string>>& rows) {
        sqlite3_stmt* prepared = nullptr;
        check(::sqlite3_prepare_v2(handle_, statement.c_str(), -1, &prepared, nullptr));
        const std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> owner(prepared, ::sqlite3_finalize);
        for (const std::vector<std::string>& row : rows) {
            for (std::size_t k = 0; k < row.size(); ++k) bind(prepared, static_cast<int>(k) + 1, row[k]);
            if (::sqlite3_step(prepared) != SQLITE_DONE) fail();
            check(::sqlite3_reset(prepared));
        }
    }

  private:
    void bind(sqlite3_stmt* statement, int place, const std::string& value) {
        if (value.empty())
            check(::sqlite3_bind_null(statement, place));
        else if (const auto number = parse_number(value))
            check(::sqlite3_bind_double(statement, place, *number));
        else
            check(::sqlite3_bind_text(statement, place, value.data(), static_cast<int>(value.size()),
                                      SQLITE_STATIC));
    }
    void check(int result) const {
        if (result != SQLITE_OK) fail();
    }
    [[noreturn]] void fail() const {
        throw OutputError(file_, std::string("cannot be written: ") + ::sqlite3_errmsg(handle_));
    }

    fs::path file_;
    sqlite3* handle_ = nullptr;
};

void add_table(Database& database, const NamedTable& added) {
    std::string columns, places;
    for (const std::string& heading : added.table.heading) {
        columns += (columns.empty() ? "" : ", ") + sql_name(heading);
        places += places.empty() ? "?" : ", ?";
    }
    database.execute("CREATE TABLE " + sql_name(added.name) + " (" + columns + ")");
    database.insert("INSERT INTO " + sql_name(added.name) + " VALUES (" + places + ")", added.table.rows);
}

void write_database(const fs::path& temporary, const fs::path& file, const std::vector<NamedTable>& tables) {
    Database database(temporary, file);
    database.execute("BEGIN");
    for (const NamedTable& added : tables) add_table(database, added);
    database.execute("COMMIT");
}

}  // namespace

void write_sqlite(const fs::path& file, const std::vector<NamedTable>& tables) {
    PendingFile pending(file);
    write_database(pending.temporary(), file, tables);
    pending.put_in_place();
}

}  // namespace rockslope::study
