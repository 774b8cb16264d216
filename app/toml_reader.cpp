#include "app/toml_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "app/nearest_name.h"
#include "app/show.h"

namespace hazer::app {

void failInShow(const std::filesystem::path& file, std::size_t line, const std::string& what) {
    throw ShowError(fmt::format("{}:{}: {}", file.string(), line, what));
}

TomlReader::TomlReader(const toml::table& table, const std::filesystem::path& file, std::string label)
    : table_(&table), file_(file), label_(std::move(label)) {}

std::size_t TomlReader::line() const {
    return table_->source().begin.line;
}

const toml::node* TomlReader::find(std::string_view key) {
    if (std::ranges::find(known_, key) == known_.end()) known_.emplace_back(key);
    return table_->get(key);
}

void TomlReader::fail(const std::string& what) const {
    failInShow(file_, line(), what);
}

void TomlReader::failAt(const toml::node& node, const std::string& what) const {
    failInShow(file_, node.source().begin.line, what);
}

const toml::node& TomlReader::required(std::string_view key) {
    const toml::node* node = find(key);
    if (node == nullptr) fail(fmt::format("{} needs '{}'", label_, key));
    return *node;
}

std::optional<std::string_view> TomlReader::oneOf(std::string_view first, std::string_view second) {
    const toml::node* other = find(second);
    if (find(first) == nullptr) return other == nullptr ? std::nullopt : std::optional(second);
    if (other != nullptr)
        failAt(*other, fmt::format("{} has both '{}' and '{}'; keep one of them", label_, first, second));
    return first;
}

std::string_view TomlReader::requiredOneOf(std::string_view first, std::string_view second) {
    const std::optional<std::string_view> key = oneOf(first, second);
    if (!key) fail(fmt::format("{} needs '{}' or '{}'", label_, first, second));
    return *key;
}

double TomlReader::numberOf(const toml::node& node, std::string_view key, Limits limits) const {
    if (!node.is_number()) failAt(node, fmt::format("'{}' in {} must be a number", key, label_));
    // A whole number that no double holds exactly is refused by value<double>(), and is a number all the
    // same.
    const double number =
        node.is_integer() ? static_cast<double>(*node.value<std::int64_t>()) : *node.value<double>();
    if (!(number >= limits.lowest && number <= limits.highest)) {
        failAt(node, fmt::format("'{}' in {} is {}, which must be {} to {}", key, label_, number,
                                 limits.lowest, limits.highest));
    }
    return number;
}

int TomlReader::integerOf(const toml::node& node, std::string_view key, Limits limits) const {
    if (!node.is_integer()) failAt(node, fmt::format("'{}' in {} must be a whole number", key, label_));
    return static_cast<int>(numberOf(node, key, limits));
}

std::string TomlReader::textOf(const toml::node& node, std::string_view key) const {
    if (!node.is_string()) failAt(node, fmt::format("'{}' in {} must be a text in quotes", key, label_));
    return *node.value<std::string>();
}

std::size_t TomlReader::choiceOf(const toml::node& node, std::string_view key,
                                 std::span<const std::string> choices) const {
    const std::string chosen = textOf(node, key);
    const auto found = std::find(choices.begin(), choices.end(), chosen);
    if (found == choices.end()) {
        failAt(node,
               fmt::format("{} has unknown {} '{}'.{}", label_, key, chosen, suggestName(chosen, choices)));
    }
    return static_cast<std::size_t>(found - choices.begin());
}

std::string TomlReader::text(std::string_view key, const std::string& otherwise) {
    const toml::node* node = find(key);
    return node == nullptr ? otherwise : textOf(*node, key);
}

std::string TomlReader::requiredText(std::string_view key) {
    const toml::node& node = required(key);
    const std::string text = textOf(node, key);
    if (text.empty()) failAt(node, fmt::format("'{}' in {} must not be empty", key, label_));
    return text;
}

double TomlReader::number(std::string_view key, double otherwise, Limits limits) {
    const toml::node* node = find(key);
    return node == nullptr ? otherwise : numberOf(*node, key, limits);
}

double TomlReader::requiredNumber(std::string_view key, Limits limits) {
    return numberOf(required(key), key, limits);
}

int TomlReader::integer(std::string_view key, int otherwise, Limits limits) {
    const toml::node* node = find(key);
    return node == nullptr ? otherwise : integerOf(*node, key, limits);
}

int TomlReader::requiredInteger(std::string_view key, Limits limits) {
    return integerOf(required(key), key, limits);
}

bool TomlReader::flag(std::string_view key, bool otherwise) {
    const toml::node* node = find(key);
    if (node == nullptr) return otherwise;
    if (!node->is_boolean()) failAt(*node, fmt::format("'{}' in {} must be true or false", key, label_));
    return *node->value<bool>();
}

glm::dvec3 TomlReader::vector(std::string_view key, const glm::dvec3& otherwise, Limits limits,
                              bool lastMayMiss) {
    const toml::node* node = find(key);
    if (node == nullptr) return otherwise;
    const toml::array* array = node->as_array();
    const std::size_t size = array == nullptr ? 0 : array->size();
    if (size != 3 && !(lastMayMiss && size == 2)) {
        failAt(*node, fmt::format("'{}' in {} must be a list of {} numbers", key, label_,
                                  lastMayMiss ? "two or three" : "three"));
    }
    glm::dvec3 vector = otherwise;
    for (std::size_t i = 0; i < size; ++i) {
        vector[static_cast<glm::length_t>(i)] = numberOf(*array->get(i), key, limits);
    }
    return vector;
}

glm::dvec3 TomlReader::requiredVector(std::string_view key, Limits limits) {
    required(key);
    return vector(key, glm::dvec3(0.0), limits);
}

std::size_t TomlReader::choice(std::string_view key, std::span<const std::string> choices,
                               std::size_t otherwise) {
    const toml::node* node = find(key);
    return node == nullptr ? otherwise : choiceOf(*node, key, choices);
}

std::size_t TomlReader::requiredChoice(std::string_view key, std::span<const std::string> choices) {
    return choiceOf(required(key), key, choices);
}

std::optional<TomlReader> TomlReader::table(std::string_view key) {
    const toml::node* node = find(key);
    if (node == nullptr) return std::nullopt;
    const toml::table* inner = node->as_table();
    if (inner == nullptr) failAt(*node, fmt::format("'{}' must be a table, [{}]", key, key));
    return TomlReader(*inner, file_, fmt::format("[{}]", key));
}

std::vector<TomlReader> TomlReader::tables(std::string_view key) {
    std::vector<TomlReader> readers;
    const toml::node* node = find(key);
    if (node == nullptr) return readers;
    const toml::array* array = node->as_array();
    if (array == nullptr)
        failAt(*node, fmt::format("'{}' must be written with two brackets, [[{}]]", key, key));
    for (const toml::node& element : *array) {
        const toml::table* inner = element.as_table();
        if (inner == nullptr) failAt(element, fmt::format("'{}' must hold tables, [[{}]]", key, key));
        readers.emplace_back(*inner, file_, fmt::format("[[{}]]", key));
    }
    return readers;
}

std::map<std::string, double> TomlReader::numbers(std::string_view key) {
    std::map<std::string, double> values;
    const toml::node* node = find(key);
    if (node == nullptr) return values;
    const toml::table* inner = node->as_table();
    if (inner == nullptr)
        failAt(*node, fmt::format("'{}' in {} must be a table, {{Dimmer = 1.0}}", key, label_));
    for (const auto& [name, value] : *inner) {
        values[std::string(name.str())] = numberOf(value, name.str(), {-1e9, 1e9});
    }
    return values;
}

void TomlReader::refuseUnknownKeys() const {
    for (const auto& [key, value] : *table_) {
        if (std::find(known_.begin(), known_.end(), key.str()) != known_.end()) continue;
        failInShow(
            file_, key.source().begin.line,
            fmt::format("unknown key '{}' in {}.{}", key.str(), label_, suggestName(key.str(), known_)));
    }
}

}  // namespace hazer::app
