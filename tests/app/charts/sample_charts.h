// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/chart_paint.h"
#include "app/charts/record_chart.h"

#include <QImage>
#include <QPainter>

#include <random>

// Records with made-up times, for the tests of charts: nothing of them is measured.

namespace sample {

/// Ten runs around a time, a few per mille apart.
inline std::vector<double> runsAround(double time, double spread, std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> noise(-1, 1);
    std::vector<double> runs(10);
    for (double& run : runs)
        run = time * (1 + spread * noise(random));
    return runs;
}

struct Times {
    const char* key;
    clipping::Form form;
    double nanoseconds;
};

inline app::Record record(std::span<const Times> all, double spread)
{
    app::Record record;
    for (const Times& times : all)
        record.timings.push_back(
            {.variant = {clipping::findAlgorithm(times.key), times.form},
             .generate = std::vector<double>(10, 5),
             .clip = runsAround(times.nanoseconds, spread, record.timings.size()),
             .draw = std::vector<double>(10, 0)});
    return record;
}

constexpr auto ours = clipping::Form::Corrected, theirs = clipping::Form::Published;

/// The seven of the paper, in its order; MD and LB do not differ.
inline app::Record seven()
{
    static constexpr Times all[]{{"CS", ours, 23.9},  {"LB", ours, 30.15},   {"CB", ours, 52.6},
                                 {"NLN", ours, 22.3}, {"Skala", ours, 26.8}, {"KWC", ours, 41.7},
                                 {"MD", ours, 30.1}};
    return record(all, 0.004);
}

/// Every form of every algorithm.
inline app::Record everything()
{
    std::vector<Times> all;
    double time = 8;
    for (const clipping::Algorithm& algorithm : clipping::algorithms())
        for (const auto form : {ours, theirs})
            if (clipping::functionsOf(algorithm, form))
                all.push_back({algorithm.key.data(), form, time *= 1.09});
    return record(all, 0.03);
}

/// Of all algorithms and forms, on the paper's scene.
inline app::OperationProfile operations()
{
    std::vector<const clipping::Algorithm*> all;
    for (const clipping::Algorithm& algorithm : clipping::algorithms())
        all.push_back(&algorithm);
    app::ExperimentOptions options;
    options.lines = 2000;
    return *app::operationProfile(options, app::variantsOf(all));
}

/// Of the corrected forms, with made-up times: each class takes longer than the one before it.
inline app::ClassProfile classes()
{
    app::ClassProfile profile{.options = {}, .classes = {}};
    for (const app::LineClass lineClass : app::lineClasses) {
        std::vector<Times> all;
        for (const clipping::Algorithm& algorithm : clipping::algorithms())
            all.push_back(
                {algorithm.key.data(), ours, (double(lineClass) + 1) * (7 + double(all.size()))});
        profile.classes.push_back({{lineClass, {}, 0.25}, record(all, 0.01)});
    }
    return profile;
}

/// The chart painted into a picture, the ground filled.
inline QImage picture(const app::Chart& chart, const app::ChartLook& look, const QSize& size,
                      double scale)
{
    QImage image(size * scale, QImage::Format_RGB32);
    image.setDevicePixelRatio(scale);
    image.fill(look.paper);
    QPainter painter(&image);
    app::paint(painter, QRectF(QPointF(), size), chart, look);
    return image;
}

} // namespace sample
