// SPDX-License-Identifier: GPL-3.0-or-later
// Prints what fingerprints_test compares, a line each, where there is no Qt.
#include "tests/clipping/fingerprint.h"

#include <cstdio>

int main()
{
    for (const Question& question : clipping::questions())
        std::printf("%s: %s\n", question.name.c_str(), fingerprint(question).c_str());
}
