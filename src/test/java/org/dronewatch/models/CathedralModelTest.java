package org.dronewatch.models;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.SplittableRandom;
import org.dronewatch.kdtree.KDTraversal;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.world.ModelSettings;
import org.dronewatch.world.ObjLoader;
import org.junit.jupiter.api.Test;

class CathedralModelTest {
    private final KDTree tree = KDTree.of(new ObjLoader(Path.of("models"))
            .load(ModelSettings.of("cathedral.obj"))
            .mesh());

    @Test
    void itHasTheSizeOfARealModel() {
        assertThat(tree.mesh().triangleCount()).isBetween(120_000, 140_000);
    }

    /** From places in nave, aisles and apse, in all directions. */
    @Test
    void noRayGetsOut() {
        long seed = 1163;
        SplittableRandom random = new SplittableRandom(seed);
        KDTraversal traversal = tree.newTraversal();
        for (int i = 0; i < 200_000; i++) {
            double x = -29 + 58 * random.nextDouble();
            double y = -11 + 22 * random.nextDouble();
            double z = 0.2 + 5.5 * random.nextDouble();
            double up = 2 * random.nextDouble() - 1;
            double angle = 2 * Math.PI * random.nextDouble();
            double level = Math.sqrt(1 - up * up);
            boolean hit = traversal.closestHit(
                    x, y, z, level * Math.cos(angle), level * Math.sin(angle), up, 0, Double.POSITIVE_INFINITY);
            assertThat(hit).as("ray %d of seed %d", i, seed).isTrue();
            assertThat(traversal.distance()).isLessThan(75.0);
        }
    }

    @Test
    void aDroneHasRoomAlongTheNave() {
        KDTraversal traversal = tree.newTraversal();
        for (double x = -20; x <= 30; x += 5) {
            for (int way = 0; way < 64; way++) {
                double angle = 2 * Math.PI * way / 64;
                assertThat(traversal.isOccluded(x, 0, 5, Math.cos(angle), Math.sin(angle), 0, 0, 4.5))
                        .as("from x = %f", x)
                        .isFalse();
            }
        }
    }

    @Test
    void theVaultIsPointed() {
        assertThat(CathedralModel.pointed(0)).isCloseTo(1.0, within(1e-12));
        assertThat(CathedralModel.pointed(1)).isCloseTo(0.0, within(1e-7));
        // A round arch would be level at its crown.
        assertThat((CathedralModel.pointed(0) - CathedralModel.pointed(0.01)) / 0.01)
                .isGreaterThan(0.2);
    }
}
