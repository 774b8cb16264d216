#include "app/attribute_values.h"

#include <gmock/gmock.h>

#include <stdexcept>

namespace hazer::app {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

TEST(AttributeValues, AreReadInTheirOrder) {
    EXPECT_THAT(parseAttributeValues("Pan=90,Tilt=-45.5"),
                ElementsAre(Pair("Pan", 90.0), Pair("Tilt", -45.5)));
    EXPECT_THAT(parseAttributeValues("Zoom=1e1"), ElementsAre(Pair("Zoom", 10.0)));
}

TEST(AttributeValues, NameWhatIsNone) {
    for (const char* text :
         {"", "Pan", "Pan=", "=3", "Pan=90,", "Pan=9o", "Pan=nan", "Pan=inf", "Pan= 3", ",Pan=1"})
        EXPECT_THROW(parseAttributeValues(text), std::runtime_error) << text;
}

}  // namespace
}  // namespace hazer::app
