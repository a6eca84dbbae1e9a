#include "Console/OptionChecks.h"

#include <sstream>

namespace idiophone {

CLI::Validator numberBetween(double lowest, double highest) {
    std::ostringstream range;
    range << lowest << " to " << highest;
    return CLI::Validator(
        [lowest, highest, text = range.str()](std::string& given) -> std::string {
            double number = 0;
            if (CLI::detail::lexical_cast(given, number) && number >= lowest && number <= highest)
                return {};
            return "'" + given + "' is not a number from " + text;
        },
        range.str());
}

} // namespace idiophone
