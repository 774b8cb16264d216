// Without Embree there is no oracle.
#include "app/report/oracle_check.h"

namespace hazer::app {

OracleResult checkAgainstOracle(const render::FloatImage&, const render::Scene&, const render::Camera&,
                                const render::Renderer&, int) {
    return {std::nullopt,
            "The oracle check is not built; configure with HAZER_ORACLE=ON, which needs Embree and Boost."};
}

}  // namespace hazer::app
