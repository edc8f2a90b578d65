// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>
#include <QScreen>
#include <QScrollBar>
#include <QTextEdit>

#include "tests/ui/fresh/makers.h"
#include "tests/ui/fresh/settled.h"
#include "tests/ui/fresh/shown_by.h"

namespace ui {

/// What is on the screen, not what a widget would paint there now.
inline QImage onScreen(const QWidget& window)
{
    const QPixmap shown = window.screen()->grabWindow(window.winId());
    return shown.toImage().convertToFormat(QImage::Format_RGB32);
}

inline QImage painted(QWidget& widget)
{
    return widget.grab().toImage().convertToFormat(QImage::Format_RGB32);
}

/// The widgets of the catalogue: one of each that stays open, and one that is hidden until it is
/// looked at. CLEARCUT_PICTURES is a folder for pictures of those that differ from a fresh one.
class Lived {
public:
    explicit Lived(quint64 seed) : desk(seed)
    {
        for (const Maker& maker : makers_)
            all_.push_back(make(maker));
        elsewhere_.show(); // and gets the keyboard
        elsewhere_.activateWindow();
        settle();
    }

    enum class Which : std::uint8_t { All, Quick };
    /// What differs from a fresh one, each in words.
    QStringList faults(Which which)
    {
        QStringList found;
        for (std::size_t i = 0; i < makers_.size(); ++i)
            if (all_[i].open && makers_[i].isShown)
                all_[i].open->setVisible(makers_[i].isShown(desk));
        elsewhere_.activateWindow(); // what is shown takes the keyboard
        if (!settle())
            found << "They do not come to rest.";
        for (const Pair& one : all_)
            if (one.open)
                scrollBack(*one.open);
        settle();
        const auto differences = desk.session.differences.asked();
        const auto exactness = desk.session.exactness.asked();
        // First all of them: what is made fresh may tell the others to look again.
        std::vector<Shown> seen(makers_.size());
        for (std::size_t i = 0; i < makers_.size(); ++i)
            if (isWanted(i, which) && all_[i].open)
                seen[i] = shownBy(*all_[i].open, onScreen(*all_[i].open));
        for (std::size_t i = 0; i < makers_.size(); ++i)
            if (isWanted(i, which))
                found << faultsOf(i, seen[i]);
        desk.session.differences.ask(differences); // as before the fresh ones have asked
        desk.session.exactness.ask(exactness);
        return found;
    }

    void resize()
    {
        for (std::size_t i = 0; i < makers_.size(); ++i) {
            const QSize size(makers_[i].size.width() * (80 + desk.below(50)) / 100,
                             makers_[i].size.height() * (80 + desk.below(50)) / 100);
            for (QWidget* widget : {all_[i].open, all_[i].hidden})
                if (widget && widget->windowType() != Qt::Popup)
                    widget->resize(size);
        }
    }

    /// Of all widgets here, also of hidden ones.
    QSet<QString> classes() const
    {
        QSet<QString> found;
        for (const Pair& one : all_)
            for (const QWidget* widget : {one.open, one.hidden})
                if (widget) {
                    found << classOf(*widget);
                    for (const QWidget* part : widget->findChildren<QWidget*>())
                        found << classOf(*part);
                }
        return found;
    }

    Desk desk;

private:
    struct Pair {
        QWidget *open = nullptr, *hidden = nullptr; ///< null: not for this row
    };

    Pair make(const Maker& maker)
    {
        Pair made;
        const auto own = [this](QWidget* widget) { return owned_.emplace_back(widget).get(); };
        const bool isCanvas = std::string_view(maker.name) == "canvas";
        QWidget* first = isCanvas ? &desk.canvas : own(maker.make(desk));
        if (first->windowType() == Qt::Popup) { // it closes as soon as anything else happens
            made.hidden = first;
        } else {
            made.open = first;
            made.open->resize(maker.size);
            made.open->move(10, 10); // not under the pointer
            open(maker, *made.open, desk);
        }
        if (made.open && !maker.alone)
            made.hidden = own(maker.make(desk));
        if (made.hidden) {
            made.hidden->setAttribute(Qt::WA_DontShowOnScreen);
            made.hidden->resize(maker.size);
        }
        return made;
    }

    bool isWanted(std::size_t i, Which which) const
    {
        return (which == Which::All || !makers_[i].slow)
               && (!makers_[i].isShown || makers_[i].isShown(desk));
    }

    QStringList faultsOf(std::size_t i, const Shown& seen)
    {
        const Maker& maker = makers_[i];
        const QSize size = (all_[i].open ? all_[i].open : all_[i].hidden)->size();
        Shown reopened;
        if (all_[i].hidden) {
            reopened = look(maker, *all_[i].hidden, size);
            all_[i].hidden->hide();
        }
        const std::unique_ptr<QWidget> fresh(maker.make(desk));
        fresh->setAttribute(Qt::WA_DontShowOnScreen);
        fresh->resize(size);
        const Shown now = look(maker, *fresh, size);
        QStringList found;
        const auto compare = [&](const char* which, const Shown& old) {
            const QString difference = differenceBetween(old, now);
            if (difference.isEmpty())
                return;
            found << QStringLiteral("%1, %2: %3").arg(maker.name, which, difference);
            const QString kind = found.back().section(" = ", 0, 0);
            if (std::exchange(told_[maker.name + QString(which)], kind) == kind)
                found.removeLast(); // as before
            keepPictures(maker.name, old.picture, now.picture);
        };
        if (all_[i].open)
            compare("open", seen);
        if (all_[i].hidden)
            compare("reopened", reopened);
        return found;
    }

    Shown look(const Maker& maker, QWidget& widget, const QSize& size)
    {
        open(maker, widget, desk);
        settle();
        if (widget.windowType() != Qt::Popup)
            widget.resize(size);                     // now it knows what it needs at least
        if (QWidget* focus = widget.focusWidget()) { // some get it when they are shown
            QFocusEvent out(QEvent::FocusOut, Qt::ActiveWindowFocusReason);
            QCoreApplication::sendEvent(focus, &out);
        }
        settle();
        scrollBack(widget);
        settle();
        return shownBy(widget, painted(widget));
    }

    /// Lists and pages of text remember how far a person has scrolled, and the columns of differing
    /// lines what they were fitted to, so that they stay while the window moves.
    static void scrollBack(QWidget& window)
    {
        if (auto* panel = qobject_cast<DifferencePanel*>(&window))
            panel->fitColumnsAnew();
        for (auto* view : window.findChildren<QAbstractItemView*>())
            view->scrollToTop();
        for (auto* text : window.findChildren<QTextEdit*>())
            text->verticalScrollBar()->setValue(0);
    }

    /// One above the other.
    static void keepPictures(const QString& name, const QImage& old, const QImage& fresh)
    {
        const QString folder = qEnvironmentVariable("CLEARCUT_PICTURES");
        if (folder.isEmpty())
            return;
        QImage both(std::max(old.width(), fresh.width()), old.height() + fresh.height() + 4,
                    QImage::Format_RGB32);
        both.fill(Qt::red);
        QPainter painter(&both);
        painter.drawImage(0, 0, old);
        painter.drawImage(0, old.height() + 4, fresh);
        both.save(folder + '/' + name + ".png");
    }

    QHash<QString, QString> told_;
    QWidget elsewhere_;
    std::vector<Maker> makers_ = makers();
    std::vector<std::unique_ptr<QWidget>> owned_;
    std::vector<Pair> all_;
};

} // namespace ui
