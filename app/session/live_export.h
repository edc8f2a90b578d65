// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/background.h"
#include "app/export/export_file.h"
#include "app/session/session.h"

#include <memory>

namespace app {

/// What an export of a session's drawing would write, as long as it is looked at: the drawing, what
/// is in it, and the size of the file. All of it is made on other threads, again after each change
/// of the drawing, the selection or the choice.
class LiveExport : public QObject {
    Q_OBJECT

public:
    explicit LiveExport(Session& session, QObject* parent = nullptr);

    const ExportChoice& choice() const { return choice_; }
    void change(ExportChoice choice);

    /// What is painted behind the drawing; empty: what is usual for the format.
    std::optional<Colour> background() const
    {
        return WriteOptions{.background = choice_.background}.backgroundOf(session_.now().page());
    }
    /// A snapshot of what is exported, with the chosen area or, if that is not possible, another.
    ExportJob job() const;
    /// Why this area cannot be exported; empty: it can.
    QString faultOf(const ExportArea& area) const;

    struct Made {
        ExportDrawing drawing;
        ExportFacts facts;
        SceneLines lines; ///< of the drawing, for the preview
    };
    /// The newest drawing that is finished; null: none yet, or the last one failed.
    const std::shared_ptr<const Made>& made() const { return made_; }
    const std::optional<qint64>& bytes() const { return bytes_; } ///< empty: not known yet
    const QString& error() const { return error_; }     ///< why nothing can be written; a sentence
    bool making() const { return maker_.active(); }     ///< `made` is not up to date
    bool counting() const { return counter_.active(); } ///< the bytes
    void wait();                                        ///< until nothing is worked on

signals:
    void changed();

private:
    using Finished = Result<std::shared_ptr<const Made>>;
    void remake();
    void take(Finished result);
    void count();

    Session& session_;
    ExportChoice choice_;
    std::shared_ptr<const Made> made_;
    std::optional<qint64> bytes_;
    QString error_;
    Background<Finished> maker_;
    Background<Result<qint64>> counter_;
};

} // namespace app
