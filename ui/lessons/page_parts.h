// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLayout>
#include <QPushButton>
#include <QScrollArea>

#include <initializer_list>

class QLabel;
class QToolButton;

namespace ui {

class PageDots;

// The parts that a page of a lesson and one of *Do it yourself* have in common.

/// How far one is, the link to all lessons, and the title below.
QVBoxLayout* pageHead(QLabel& place, QToolButton& all, QLabel& title);
QToolButton* linkToLessons();
/// Scrolls if there is too little room; takes `inner`.
void makePageBody(QScrollArea& body, QWidget& inner);
/// Marks an answer that was tried or is right, with a sign, in colour and in words.
void markAnswer(QPushButton& button, bool right);
/// The dots, the number of the page, and the buttons at the right.
QHBoxLayout* pageFoot(PageDots& dots, QLabel& count, std::initializer_list<QPushButton*> turns);

} // namespace ui
