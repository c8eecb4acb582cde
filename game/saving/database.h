// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace sl {

/// One connection to an SQLite database. Every failure is an Error that names the file and says why.
class Database {
  public:
    enum class Access { create, write, read };

    /// `create`: there must be no such file yet. `read`: of a file that nobody changes meanwhile.
    Database(const std::filesystem::path& path, Access access);

    void run(const std::string& sql);

    /// A prepared statement; parameters and columns count from 0.
    class Statement {
      public:
        Statement(Database& database, std::string_view sql);

        Statement& bind(int parameter, std::int64_t value);
        Statement& bind(int parameter, std::string_view text);
        /// Goes on to the next row; false after the last.
        bool next();
        /// For other parameters.
        void reset();
        std::int64_t integer(int column) const;
        std::string text(int column) const;

      private:
        struct Finalize {
            void operator()(sqlite3_stmt* statement) const;
        };
        Database& database_;
        std::unique_ptr<sqlite3_stmt, Finalize> statement_;
    };

    std::int64_t integer(std::string_view sql);

  private:
    [[noreturn]] void fail_with(int code) const;

    struct Close {
        void operator()(sqlite3* connection) const;
    };
    std::filesystem::path path_;
    std::unique_ptr<sqlite3, Close> connection_;
};

}  // namespace sl
