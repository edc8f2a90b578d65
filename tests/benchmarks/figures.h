// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/clock.h"

#include <QTextStream>

#include <algorithm>
#include <utility>
#include <vector>

// What benchmarks print: a name, a number and its unit a line, as before_after.py reads them.

/// The milliseconds of processor time that some work takes in this thread: other programs do not
/// count, nor do other threads.
template <class Work>
double processorTime(Work work)
{
    static const app::Clock clock = app::processorClock();
    const double before = clock.nanoseconds();
    work();
    return (clock.nanoseconds() - before) * 1e-6;
}

/// The milliseconds that pass while some work is done.
template <class Work>
double elapsedTime(Work work)
{
    static const app::Clock clock = app::wallClock();
    const double before = clock.nanoseconds();
    work();
    return (clock.nanoseconds() - before) * 1e-6;
}

/// Milliseconds of processor time of the same work done several times.
struct Figures {
    std::vector<double> times;

    template <class Work>
    static Figures of(int rounds, Work work)
    {
        Figures figures;
        for (int i = 0; i < rounds; ++i)
            figures.times.push_back(processorTime([&] { work(i); }));
        return figures;
    }
};

/// Prints figures as rows of one table.
class FigureTable {
public:
    void print(const QByteArray& what, double value, const char* unit)
    {
        name(what) << value << ' ' << unit << Qt::endl;
    }
    void print(const QByteArray& what, Figures figures)
    {
        std::ranges::sort(figures.times);
        const auto& times = figures.times;
        name(what) << "median " << times[times.size() / 2] << " ms, least " << times.front()
                   << ", worst " << times.back() << Qt::endl;
    }

private:
    QTextStream& name(const QByteArray& what)
    {
        return out_ << qSetFieldWidth(40) << Qt::left << what << qSetFieldWidth(0);
    }
    QTextStream out_{stdout};
};
