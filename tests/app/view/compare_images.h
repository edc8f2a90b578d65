// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

#include <algorithm>
#include <cstdlib>

/// Calls `visit` with the distance of every byte of the premultiplied colours of two pictures of
/// one size, of 255.
template <class Visit>
void visitDistances(const QImage& a, const QImage& b, Visit visit)
{
    const auto format = QImage::Format_ARGB32_Premultiplied;
    const QImage left = a.convertToFormat(format), right = b.convertToFormat(format);
    for (int y = 0; y < left.height(); ++y)
        for (qsizetype i = 0; i < left.bytesPerLine(); ++i)
            visit(std::abs(left.constScanLine(y)[i] - right.constScanLine(y)[i]));
}

/// The greatest of them; pictures of different sizes are as far apart as can be.
inline int farthest(const QImage& a, const QImage& b)
{
    int most = a.size() == b.size() ? 0 : 255;
    if (most == 0)
        visitDistances(a, b, [&](int distance) { most = std::max(most, distance); });
    return most;
}

/// The share of bytes that are farther apart than `distance`.
inline double shareBeyond(const QImage& a, const QImage& b, int distance)
{
    double beyond = 0, all = 0;
    visitDistances(a, b, [&](int found) {
        beyond += found > distance;
        ++all;
    });
    return all > 0 ? beyond / all : 0;
}
