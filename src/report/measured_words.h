#pragma once

#include "diagnose/diagnosis.h"

#include <string>

namespace tumble::report {

/// "0.1860 &plusmn; 0.0005": both to the second digit of the error, with a true minus sign; the value in four digits
/// where there is no error. For HTML.
std::string with_error(double value, double error);

/// With a true minus sign in place of "-"; "-0.0" is "0.0".
std::string with_minus(std::string number);

/// Which scene, by its file and a hash of its text, and what was set beside it; as HTML.
std::string scene_words(const diagnose::Diagnosis& diagnosis);

} // namespace tumble::report
