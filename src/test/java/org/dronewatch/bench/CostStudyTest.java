package org.dronewatch.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.world.ModelSettings;
import org.dronewatch.world.ObjLoader;
import org.junit.jupiter.api.Test;

/** The study of costs, with hardly any time to measure: what it measures, not how long that takes. */
class CostStudyTest {
    private static final Stopwatch HASTY = new Stopwatch(0, 1);

    @Test
    void everyLineHasACostForEachQuantity() {
        TriangleMesh drone = new ObjLoader(Path.of(""))
                .load(ModelSettings.packaged("quadrotor.obj"))
                .mesh();
        List<String> told = new ArrayList<>();
        List<CostCurves> all = new CostStudy(drone, 3000, HASTY, told::add).run();
        assertThat(all)
                .extracting(CostCurves::name)
                .containsExactly("build", "triangles", "memory", "rays", "sensors", "drones", "threads");
        for (CostCurves curves : all) {
            List<Double> quantities = curves.lines().get(0).x();
            assertThat(quantities).isSorted().doesNotHaveDuplicates().isNotEmpty();
            for (CostCurves.Line line : curves.lines()) {
                assertThat(line.x()).as(line.name()).isEqualTo(quantities);
                assertThat(line.y()).as(line.name()).hasSameSizeAs(quantities).allMatch(y -> y > 0.0);
            }
        }
        assertThat(told).contains("the tree of 968 triangles", "diffuse rays", "64 sensors", "64 drones", "1 threads");
    }

    @Test
    void theLargestGroundIsTheLastWhateverItsSize() {
        assertThat(TracingStudy.sizes(1000)).containsExactly(1000);
        assertThat(TracingStudy.sizes(1300)).containsExactly(1000, 1300);
        assertThat(TracingStudy.sizes(5000)).containsExactly(1000, 5000);
        assertThat(TracingStudy.sizes(20_000_000))
                .containsExactly(1000, 5000, 25_000, 125_000, 625_000, 3_125_000, 15_625_000, 20_000_000);
    }
}
