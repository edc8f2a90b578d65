// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/writer.h"
#include "app/recovery/journal.h"
#include "app/recovery/journal_folder.h"
#include "app/recovery/journal_reading.h"

#include <QBuffer>
#include <QDir>
#include <QTemporaryDir>

/// A drawing that is edited while its journal is written.
struct RecordedDrawing {
    explicit RecordedDrawing(app::Document start, const QString& above,
                             const app::Journal::Limits& limits = {})
        : document(std::move(start)), journal(document, history, above, limits)
    {
    }
    app::EditedDocument document;
    app::History history;
    app::Journal journal;
};

inline QByteArray svgOf(const app::Document& document)
{
    QBuffer out;
    out.open(QIODevice::WriteOnly);
    return app::svg::write(document, out, {}) ? QByteArray() : out.data();
}

/// All that a recovery restores, as text to compare.
struct RecordedState {
    QByteArray svg;
    QStringList texts;
    int index = 0;
    std::optional<int> clean;
    friend bool operator==(const RecordedState&, const RecordedState&) = default;
};

inline RecordedState stateOf(const app::Document& document, const app::History& history)
{
    RecordedState state{svgOf(document), {}, history.index(), history.cleanIndex()};
    for (int i = 0; i < history.count(); ++i)
        state.texts << history.text(i);
    return state;
}

inline RecordedState stateOf(const app::Recovered& recovered)
{
    RecordedState state{
        svgOf(recovered.document), {}, recovered.history.index, recovered.history.clean};
    for (const auto& step : recovered.history.steps)
        state.texts << step.text;
    return state;
}
