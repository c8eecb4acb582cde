// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace sl {

/// A table of measured figures that the tests fill and that a page of the documentation shows: no number there is typed.
/// With SECONDLIGHT_TABLES=1 it replaces what stands in that page between "<!-- NAME -->" and "<!-- end of NAME -->" when
/// the program ends, provided that every test ran; otherwise nothing is written.
class ResultTable : public testing::Environment {
  public:
    ResultTable(std::string name, std::string page, std::string corner, std::vector<std::string> columns,
                std::vector<std::string> first_rows = {})
        : name_(std::move(name)), page_(std::move(page)), corner_(std::move(corner)), columns_(std::move(columns)), rows_(std::move(first_rows)) {}

    void say(const std::string& row, const std::string& column, const std::string& text) { cell(row, column) = text; }

    /// Keeps the larger one where a cell is measured more than once.
    void worst(const std::string& row, const std::string& column, double value, const std::string& prefix = "", const std::string& suffix = "") {
        double& known = values_[{row, column}];
        known = std::max(known, value);
        cell(row, column) = prefix + figure(known) + suffix;
    }

    /// Percent, or a power of ten where percent would be all zeros.
    static std::string figure(double value) {
        if (value == 0.0) return "0";
        if (value < 5e-5) return fmt::format("{:.0e}", value);
        if (value < 5e-3) return fmt::format("{:.2f} %", 100.0 * value);
        return value < 0.1 ? fmt::format("{:.1f} %", 100.0 * value) : fmt::format("{:.0f} %", 100.0 * value);
    }

    void TearDown() override {
        const auto* run = testing::UnitTest::GetInstance();
        if (std::getenv("SECONDLIGHT_TABLES") == nullptr || run->test_to_run_count() != run->total_test_count()) return;
        // Tests that skip have measured nothing: what stands there stays.
        if (rows_.empty()) return;
        std::ifstream in(page_);
        std::stringstream text;
        text << in.rdbuf();
        std::string page = text.str();
        const std::string begin = "<!-- " + name_ + " -->\n", end = "<!-- end of " + name_ + " -->";
        const auto first = page.find(begin), last = page.find(end);
        if (first == std::string::npos || last == std::string::npos) {
            ADD_FAILURE() << page_ << " has no place for the table " << name_;
            return;
        }
        page.replace(first + begin.size(), last - first - begin.size(), markdown());
        std::ofstream(page_) << page;
    }

  private:
    std::string& cell(const std::string& row, const std::string& column) {
        if (std::ranges::find(rows_, row) == rows_.end()) rows_.push_back(row);
        return cells_[{row, column}];
    }
    std::string markdown() const {
        std::string text = "| " + corner_ + " |", rule = "| --- |";
        for (const std::string& column : columns_) {
            text += " `" + column + "` |";
            rule += " --- |";
        }
        text += "\n" + rule + "\n";
        for (const std::string& row : rows_) {
            text += "| " + row + " |";
            for (const std::string& column : columns_) {
                const auto found = cells_.find({row, column});
                text += " " + (found != cells_.end() ? found->second : std::string("–")) + " |";
            }
            text += "\n";
        }
        return text;
    }

    std::string name_, page_, corner_;
    std::vector<std::string> columns_, rows_;
    std::map<std::pair<std::string, std::string>, std::string> cells_;
    std::map<std::pair<std::string, std::string>, double> values_;
};

}  // namespace sl
