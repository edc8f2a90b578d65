// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/background.h"
#include "app/session/session.h"
#include "app/tiles/sheet_settings.h"

namespace app {

/// The sheets among which a session's drawing is divided, while they are shown and exported. The
/// drawing is cut at its own clip windows first, as for any export: a large one in the background.
/// How the drawing is divided is saved with it: `keep` makes a step of it. A drawing without
/// a division begins with the last one that was chosen, but for its name, shift and sheets left
/// out.
class LiveSheets : public QObject {
    Q_OBJECT

public:
    explicit LiveSheets(Session& session, QObject* parent = nullptr);

    bool isOpen() const { return open_; }
    void open();
    void close(); ///< keeps the division, too
    /// Makes a step of the division, if a person has chosen another one. To be called before the
    /// document is saved.
    void keep();

    const SheetSettings& settings() const { return settings_; }
    /// Takes other settings. Returns a sentence that says why no sheets can be made by them; then
    /// the old ones stay, unless these are no better.
    std::optional<QString> change(SheetSettings next);
    /// The sheets; the error says why there are none. Only valid while open.
    const Result<Tiling>& tiling() const { return tiling_; }

    const QString& title() const { return title_; }
    void setTitle(const QString& title); ///< the name of the drawing, without an ending

    /// What is divided: the drawing, cut at its own windows. Only valid while open.
    const Document& drawing() const { return cut_ ? cut_->document.now() : session_.now(); }
    Scene& scene() { return cut_ ? cut_->scene : session_.scene; }
    bool cutting() const { return cutter_.active(); } ///< `drawing` is not up to date yet
    void wait() { cutter_.wait(); }                   ///< until it is

    /// What is exported; there is a tiling.
    Sheets sheets() const;
    /// Files to be written, by their names; empty without a tiling.
    QStringList files() const;

signals:
    void openChanged();
    void changed(); ///< anything that is shown

private:
    void follow();
    void forget();
    void take();
    void divide();
    Result<Tiling> divided(const SheetSettings& settings);
    void cutDrawing();
    CutOptions cutOptions() const; ///< as for an export; without a region

    struct CutDrawing {
        explicit CutDrawing(Document drawing) : document(std::move(drawing)) {}
        EditedDocument document;
        Scene scene{document};
    };
    Session& session_;
    SheetSettings settings_;
    Result<Tiling> tiling_ = Result<Tiling>::failure({});
    QString title_;
    std::unique_ptr<CutDrawing> cut_; ///< null: the drawing has no clip windows
    Background<Document> cutter_;
    std::optional<PageSheets> kept_; ///< the division that the document has, or began with
    bool open_ = false;
};

} // namespace app
