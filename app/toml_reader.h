// Typed access to a TOML table in which every mistake becomes a ShowError with file and line.
#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hazer::app {

/// Inclusive limits of a number.
struct Limits {
    double lowest;
    double highest;
};

/// Reads one table. Each key that is asked for counts as known; refuseUnknownKeys() then names the others.
/// All throw ShowError.
class TomlReader {
 public:
    /// `label` names the table in messages, such as "[haze]". The table must outlive the reader; `file` is in
    /// messages only.
    TomlReader(const toml::table& table, const std::filesystem::path& file, std::string label);

    std::size_t line() const;

    /// Whether the table has the key; it counts as known.
    bool has(std::string_view key) { return find(key) != nullptr; }

    /// Which of two keys that mean the same the table has; both are refused.
    std::optional<std::string_view> oneOf(std::string_view first, std::string_view second);
    std::string_view requiredOneOf(std::string_view first, std::string_view second);

    std::string text(std::string_view key, const std::string& otherwise);
    std::string requiredText(std::string_view key);
    double number(std::string_view key, double otherwise, Limits limits);
    double requiredNumber(std::string_view key, Limits limits);
    int integer(std::string_view key, int otherwise, Limits limits);
    int requiredInteger(std::string_view key, Limits limits);
    bool flag(std::string_view key, bool otherwise);

    /// Three numbers, or two if `lastMayMiss`: the third is then that of `otherwise`.
    glm::dvec3 vector(std::string_view key, const glm::dvec3& otherwise, Limits limits,
                      bool lastMayMiss = false);
    glm::dvec3 requiredVector(std::string_view key, Limits limits);

    /// One of `choices`, as an index into them.
    std::size_t choice(std::string_view key, std::span<const std::string> choices, std::size_t otherwise);
    std::size_t requiredChoice(std::string_view key, std::span<const std::string> choices);

    /// A table in this one. Empty if it is not there.
    std::optional<TomlReader> table(std::string_view key);

    /// An array of tables, [[key]] in the file.
    std::vector<TomlReader> tables(std::string_view key);

    /// All keys of a table whose values are numbers.
    std::map<std::string, double> numbers(std::string_view key);

    /// Call after everything was read.
    void refuseUnknownKeys() const;

    /// Throws ShowError: "FILE:LINE: <what>".
    [[noreturn]] void fail(const std::string& what) const;

 private:
    const toml::node* find(std::string_view key);
    [[noreturn]] void failAt(const toml::node& node, const std::string& what) const;
    double numberOf(const toml::node& node, std::string_view key, Limits limits) const;
    int integerOf(const toml::node& node, std::string_view key, Limits limits) const;
    std::string textOf(const toml::node& node, std::string_view key) const;
    std::size_t choiceOf(const toml::node& node, std::string_view key,
                         std::span<const std::string> choices) const;
    const toml::node& required(std::string_view key);

    const toml::table* table_;
    std::filesystem::path file_;
    std::string label_;
    std::vector<std::string> known_;
};

/// Throws ShowError: "FILE:LINE: <what>".
[[noreturn]] void failInShow(const std::filesystem::path& file, std::size_t line, const std::string& what);

}  // namespace hazer::app
