package org.dronewatch.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.dronewatch.Thorough;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.mesh.io.ModelLoader;
import org.dronewatch.mesh.io.ModelSettings;
import org.junit.jupiter.api.Test;

/** The study of costs, with hardly any time to measure: what it measures, not how long that takes. */
class CostStudyTest {
    private static final Stopwatch HASTY = new Stopwatch(0, 1, System::nanoTime);

    @Thorough
    @Test
    void everyLineHasACostForEachQuantity() {
        TriangleMesh drone = new ModelLoader(Path.of(""))
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
        assertThat(told).contains("the tree of 968 triangles", "diffuse rays", "64 sensors", "64 drones", "1 thread");
    }

    /** By a clock for which everything takes a second, rates are numbers of rays. */
    @Thorough
    @Test
    void whatIsTraced() {
        AtomicLong second = new AtomicLong();
        Stopwatch everySecond = new Stopwatch(0, 1, () -> second.getAndAdd(1_000_000_000L));
        List<CostCurves> all = new TracingStudy(2000, everySecond, next -> {}).run();
        assertThat(all.get(1).lines())
                .extracting(CostCurves.Line::name, line -> line.y().get(1))
                .containsExactly(
                        tuple("pictures of 1920 x 1080", 1e-6 * 1920 * 1080),
                        tuple("pictures of 1024 x 768", 1e-6 * 1024 * 768),
                        tuple("1024 x 768, rays one by one", 1e-6 * 1024 * 768),
                        tuple("diffuse rays", 1.0));
        // 36 bytes of corners, and the tree.
        assertThat(all.get(2).lines().get(0).y()).allMatch(bytes -> bytes > 40 && bytes < 100);
    }

    @Test
    void theLargestGroundIsTheLastWhateverItsSize() {
        assertThat(TracingStudy.sizes(1000)).containsExactly(1000);
        assertThat(TracingStudy.sizes(1300)).containsExactly(1000, 1300);
        assertThat(TracingStudy.sizes(5000)).containsExactly(1000, 5000);
        assertThat(TracingStudy.sizes(5001)).containsExactly(1000, 5001);
        assertThat(TracingStudy.sizes(20_000_000))
                .containsExactly(1000, 5000, 25_000, 125_000, 625_000, 3_125_000, 15_625_000, 20_000_000);
    }
}
