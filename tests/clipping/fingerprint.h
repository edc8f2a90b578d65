// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstdio>
#include <map>
#include <string>

#include "tests/clipping/answers.h"
#include "tests/clipping/blocks.h"

/// FNV-1a of 64 bits over the answers to a question about every hard block, in hexadecimal.
inline std::string fingerprint(const Question& question)
{
    static std::map<Numbers, std::vector<Block>> all; // many questions have the same numbers
    auto& blocks = all[question.numbers];
    if (blocks.empty())
        blocks = hardBlocks(question.numbers, 3000);
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const Block& block : blocks)
        for (const std::byte byte : clipping::answers(question, block))
            hash = (hash ^ std::uint64_t(byte)) * 0x100000001b3;
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}
