// What hazer explain says of a show is what a session of it draws with.
#include "app/explanation.h"

#include <gtest/gtest.h>

#include "app/assignment.h"
#include "app/paths.h"
#include "app/session.h"
#include "render/error.h"
#include "render/gl/headless_context.h"
#include "tests/support/resource_check.h"

namespace hazer::app {
namespace {

class ExplanationGlTest : public ::testing::Test {
 protected:
    void SetUp() override {
        try {
            context_ = std::make_unique<render::gl::HeadlessContext>();
        } catch (const render::NoGlError& error) {
            GTEST_SKIP() << error.what();
        }
    }

    static void expectDrawnAsExplained(const std::filesystem::path& file,
                                       const std::vector<std::string>& assignments = {}) {
        SCOPED_TRACE(file.string());
        const Show show = loadShow(file);
        const Explanation explanation = explainShow(show, {assignments, {}, 160, 90});
        Session session(show, {});
        session.settings().width = 160;
        session.settings().height = 90;
        for (const std::string& assignment : assignments) assign(assignment, session.patch());
        session.advance(0.0);
        session.settle();
        session.draw();
        test::expectAsPlanned(explanation.summary, session.renderer());
    }

 private:
    std::unique_ptr<render::gl::HeadlessContext> context_;
};

TEST_F(ExplanationGlTest, ShippedShows) {
    expectDrawnAsExplained(showFolder() / "thesis.toml");
    expectDrawnAsExplained(showFolder() / "one-spot.toml");
    expectDrawnAsExplained(showFolder() / "one-spot.toml", {"spot1.Dimmer=1", "spot1.Gobo1=3"});
    expectDrawnAsExplained(showFolder() / "demo.toml");
}

TEST_F(ExplanationGlTest, TheWholeDemoLit) {
    const std::filesystem::path file = showFolder() / "demo.toml";
    std::vector<std::string> assignments;
    for (const std::string& name : Patch(loadShow(file)).fixtureNames())
        assignments.push_back(name + ".Dimmer=1");
    expectDrawnAsExplained(file, assignments);
}

TEST_F(ExplanationGlTest, EveryAccuracyShow) {
    for (const auto& entry : std::filesystem::directory_iterator(showFolder() / "accuracy")) {
        if (entry.path().extension() == ".toml") expectDrawnAsExplained(entry.path());
    }
}

}  // namespace
}  // namespace hazer::app
