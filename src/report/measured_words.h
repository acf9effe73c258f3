#pragma once

#include <string>

namespace tumble::report {

/// "0.1860 &plusmn; 0.0005": both to the second digit of the error, with a true minus sign; the value in four digits
/// where there is no error. For HTML.
std::string with_error(double value, double error);

/// With a true minus sign in place of "-"; "-0.0" is "0.0".
std::string with_minus(std::string number);

} // namespace tumble::report
