// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// The input of a question: the numbers of a window and of the segments that are clipped at
/// it. All kinds are stored as double; those for float hold only floats.
struct Block {
    std::string name;
    std::vector<double> window;   ///< xmin, ymin, xmax, ymax; in space with z; or corners x, y ...
    std::vector<double> segments; ///< four numbers each; in space six
};

/// The kinds of numbers that a question takes.
enum class Numbers { Plane, PlaneInFloat, Space, Polygon };

/// One question to the library: a row, a form and a use ("skala published double").
struct Question {
    std::string name;
    Numbers numbers;
};

/// The answers to one question about one block, as bytes: each segment's piece by `clip`, all
/// pieces with source and cut by `clipAll`, and the counted operations. Every NaN has the same
/// bits.
using Answers = std::vector<std::byte>;

namespace clipping {
std::vector<Question> questions();
Answers answers(const Question& question, const Block& block);
} // namespace clipping
