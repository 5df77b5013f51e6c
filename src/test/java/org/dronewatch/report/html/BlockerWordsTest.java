package org.dronewatch.report.html;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.dronewatch.analysis.survey.Blocker;
import org.dronewatch.buildings.BuildingOutline;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.world.Obstacle;
import org.dronewatch.world.SiteModel;
import org.junit.jupiter.api.Test;

class BlockerWordsTest {
    private static Blocker of(ModelRole role, String file) {
        return new Blocker(new Obstacle(new SiteModel(file, role), ""), Optional.empty());
    }

    private static Blocker building(Optional<String> name) {
        BuildingOutline outline =
                new BuildingOutline("way/7", name, false, new double[] {0, 0, 9, 0, 9, 9}, List.of(), 0.0, 6.0, false);
        return new Blocker(new Obstacle(new SiteModel("site.osm", ModelRole.BUILDING), ""), Optional.of(outline));
    }

    @Test
    void whatASensorStandsOnIsNamedAsAUserKnowsIt() {
        assertThat(BlockerWords.footing(of(ModelRole.TERRAIN, "hill.asc"))).isEqualTo("the ground");
        assertThat(BlockerWords.footing(of(ModelRole.VEGETATION, "site.osm"))).isEqualTo("trees");
        assertThat(BlockerWords.footing(of(ModelRole.OTHER, "crane.obj"))).isEqualTo("crane.obj");
        assertThat(BlockerWords.footing(of(ModelRole.BUILDING, ""))).isEqualTo("a model");
        assertThat(BlockerWords.footing(building(Optional.of("reactor hall")))).isEqualTo("'reactor hall'");
        assertThat(BlockerWords.footing(building(Optional.empty()))).isEqualTo("building way/7");
    }
}
