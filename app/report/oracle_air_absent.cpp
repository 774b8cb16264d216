// Without Embree there is no oracle.
#include "app/report/oracle_air.h"

namespace hazer::app {

std::vector<double> oracleAir(const render::Scene&, const render::Camera&, int,
                              const std::vector<render::Mesh>&, const std::vector<glm::ivec2>&) {
    return {};
}

}  // namespace hazer::app
