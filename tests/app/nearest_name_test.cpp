#include "app/nearest_name.h"

#include <gtest/gtest.h>

#include <vector>

namespace hazer::app {
namespace {

const std::vector<std::string> kNames{"extinction", "scattering", "noise", "noise_scale"};

TEST(NearestName, forgivesAMisspelling) {
    EXPECT_EQ(nearestName("extinctoin", kNames), "extinction");
    EXPECT_EQ(nearestName("NOISE", kNames), "noise");
    EXPECT_EQ(nearestName("noisescale", kNames), "noise_scale");
}

TEST(NearestName, suggestsNothingForSomethingElse) {
    EXPECT_EQ(nearestName("colour", kNames), "");
    EXPECT_EQ(nearestName("", kNames), "");
    EXPECT_EQ(nearestName(std::string(1000, 'x'), kNames), "");
}

TEST(SuggestName, listsWhatThereIs) {
    EXPECT_EQ(suggestName("nose", kNames),
              " Did you mean 'noise'? There are extinction, scattering, noise and noise_scale.");
    EXPECT_EQ(suggestName("colour", std::vector<std::string>{"noise"}), " There is noise.");
    EXPECT_EQ(suggestName("colour", std::vector<std::string>{}), " There are none.");
}

}  // namespace
}  // namespace hazer::app
