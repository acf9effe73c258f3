#pragma once

#include "lesson/lesson.h"

/// The lessons, one file each.
namespace tumble::lesson {

Lesson two_discs();
Lesson force_law();
Lesson time_step();
Lesson restitution();
Lesson energy();
Lesson friction();
Lesson rolling_resistance();
Lesson clumps();
Lesson repose();
Lesson soft_and_hard();

} // namespace tumble::lesson
