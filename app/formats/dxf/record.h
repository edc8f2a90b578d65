// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/dxf/pairs.h"

#include <glm/vec3.hpp>

#include <vector>

namespace app::dxf {

/// Thrown for a value that is no number where one must be; one entity is left out.
struct BadValue {};

/// A finite number; throws BadValue.
double numberOf(std::string_view text);
int integerOf(std::string_view text); ///< throws BadValue

/// The pairs from a code 0 up to the next one: an entity, an entry of a table, the beginning of a
/// section. A code may occur several times; the functions take the first.
struct Record {
    std::string_view type; ///< the value of code 0
    qint64 line = 0;       ///< of the code 0
    std::vector<Pair> pairs{};

    const Pair* find(int code) const; ///< null: there is none
    bool has(int code) const { return find(code) != nullptr; }
    std::string_view text(int code, std::string_view otherwise = {}) const;
    double number(int code, double otherwise = 0) const;
    int integer(int code, int otherwise = 0) const;
    /// The codes `code`, `code` + 10 and `code` + 20.
    glm::dvec3 point(int code, const glm::dvec3& otherwise = {}) const;
};

/// All points that begin with this code, each with the numbers that follow it up to the next one.
std::vector<glm::dvec3> pointsOf(const Record& record, int code);
std::vector<double> numbersOf(const Record& record, int code);

/// Reads a file record by record. A copy continues at the same place.
class Records {
public:
    Records() : Records(std::string_view()) {}
    explicit Records(std::string_view text);

    /// The next record; false at the end, or at damage. Reuses the memory of `record`.
    bool next(Record& record);
    std::string_view nextType() const { return type_; } ///< empty at the end
    bool damaged() const { return damaged_; }
    qint64 line() const { return pairs_.line(); }
    std::size_t pairsRead() const { return read_; }

private:
    bool take(Pair& pair);

    Pairs pairs_;
    std::string_view type_; ///< of the next record
    qint64 lineOfType_ = 0;
    std::size_t read_ = 0;
    bool damaged_ = false;
};

} // namespace app::dxf
