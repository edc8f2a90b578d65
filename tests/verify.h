// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

/// QVERIFY2, with a text that is made only for a failure. For loops: a text with all numbers of an
/// input takes longer than the test of it.
#define VERIFY_OR_SAY(condition, text)                                                             \
    do {                                                                                           \
        if (!(condition))                                                                          \
            QFAIL(text);                                                                           \
    } while (false)
