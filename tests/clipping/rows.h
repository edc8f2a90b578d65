// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

#include <QTest>

/// Data of a test function: every row of the catalogue, as `algorithm`.
inline void everyAlgorithm()
{
    QTest::addColumn<const clipping::Algorithm*>("algorithm");
    for (const clipping::Algorithm& a : clipping::algorithms())
        QTest::newRow(a.key.data()) << &a;
}
