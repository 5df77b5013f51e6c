package org.dronewatch.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.HashSet;
import java.util.Set;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.Stage;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RecordedRaysTest {
    @TempDir
    private Path directory;

    @Test
    void aPathThatReachedTheSensorIsHeardFromItsBeginningOn() {
        RayCollector collector = new RayCollector("microphone", "drone", 8.0);
        collector.record(0, 0, 0, 10, 0, 0, 50, 0, false);
        collector.record(0, 0, 0, 0, 10, 0, 50, 0, false);
        collector.record(10, 0, 0, 10, 10, 0, 45, 1, false);
        collector.record(10, 0, 0, 20, 10, 0, 44, 1, false);
        collector.record(10, 10, 0, 0, 20, 0, 40, 2, true);
        collector.record(0, 0, 0, 0, 20, 0, 48, 0, true);
        RecordedRays rays = collector.toRays();

        boolean[] heard = new boolean[rays.count()];
        for (int i = 0; i < heard.length; i++) {
            heard[i] = rays.isHeard(i);
        }

        assertThat(heard).containsExactly(true, false, true, false, true, true);
        assertThat(rays.maxOrder()).isEqualTo(2);
        assertThat(new RayFilter(0, 9, true).count(rays)).isEqualTo(4);
        assertThat(new RayFilter(1, 1, false).count(rays)).isEqualTo(2);
        assertThat(new RayFilter(1, 1, true).count(rays)).isEqualTo(1);
        assertThat(RayFilter.ALL.count(rays)).isEqualTo(6);
    }

    @Test
    void everyHeardPathOfTheLevelModelLeadsBackToTheDrone() {
        Yard yard = new Yard(directory);
        var stage = yard.stage();
        RayCollector collector = new RayCollector("microphone", "quadrotor", 8.0);
        assertThat(stage.traceRays(8.0, "microphone", "quadrotor", collector)).isTrue();
        assertThat(stage.traceRays(8.0, "camera", "quadrotor", collector)).isFalse();
        assertThat(stage.traceRays(8.0, "microphone", "nobody", collector)).isFalse();
        RecordedRays rays = collector.toRays();

        int heardOfOrderZero = 0;
        int heardLater = 0;
        int received = 0;
        for (int i = 0; i < rays.count(); i++) {
            heardOfOrderZero += rays.isHeard(i) && rays.order(i) == 0 ? 1 : 0;
            heardLater += rays.isHeard(i) && rays.order(i) > 0 ? 1 : 0;
            received += rays.isHeard(i) ? 1 : 0;
        }
        assertThat(rays.count()).isGreaterThan(20);
        // The direct way, and the beginnings of those by way of lawn and wall.
        assertThat(heardOfOrderZero).isGreaterThan(1);
        assertThat(heardLater).isPositive();
        assertThat(received).isLessThan(rays.count());
    }

    /** The straight path, and rays from one end that pass the other or are scattered to it. */
    @Test
    void everyHeardPathOfTheEnergyModelJoinsDroneAndSensor() {
        SceneRunner runner = new SceneRunner(new Yard(directory)).set("sensors.microphone.propagation", "energy-model");
        Stage stage = runner.stage(runner.settings());
        RayCollector collector = new RayCollector("microphone", "quadrotor", 8.0);
        Set<Position> starts = new HashSet<>();
        Set<Position> targets = new HashSet<>();
        int[] received = new int[2];
        stage.traceRays(
                8.0, "microphone", "quadrotor", (fromX, fromY, fromZ, toX, toY, toZ, level, order, isReceived) -> {
                    collector.record(fromX, fromY, fromZ, toX, toY, toZ, level, order, isReceived);
                    if (isReceived) {
                        targets.add(new Position(toX, toY, toZ));
                        received[order == 0 ? 0 : 1]++;
                    }
                    if (order == 0) {
                        starts.add(new Position(fromX, fromY, fromZ));
                    }
                });
        RecordedRays rays = collector.toRays();

        assertThat(starts).hasSize(1);
        assertThat(targets).hasSize(1).doesNotContainAnyElementsOf(starts);
        starts.addAll(targets);
        assertThat(starts).contains(Yard.SENSORS.plus(new Position(3, 0, 0)));
        assertThat(received[0]).as("the straight path").isEqualTo(1);
        assertThat(received[1]).isGreaterThan(10);
        // Each path that is heard later begins with a segment of order 0, which may be that of several.
        int heardAtOnce = new RayFilter(0, 0, true).count(rays);
        assertThat(heardAtOnce).isBetween(2, 1 + received[1]);
        for (int order = 1; order <= rays.maxOrder(); order++) {
            int before = new RayFilter(order - 1, order - 1, true).count(rays);
            assertThat(new RayFilter(order, order, true).count(rays)).isLessThanOrEqualTo(2 * before);
        }
        assertThat(new RayFilter(0, 99, true).count(rays)).isLessThan(rays.count());
    }

    @Test
    void moreThanCanBeKeptIsCounted() {
        RayCollector collector = new RayCollector("microphone", "drone", 8.0);
        for (int i = 0; i < RayCollector.MOST + 5; i++) {
            collector.record(0, 0, 0, 1, 1, i, 50, 0, false);
        }
        RecordedRays rays = collector.toRays();
        assertThat(rays.count()).isEqualTo(RayCollector.MOST);
        assertThat(rays.leftOut()).isEqualTo(5);
    }

    @Test
    void aScaleHoldsAllLevelsAndItsEndsDiffer() {
        RayCollector one = new RayCollector("microphone", "drone", 8.0);
        one.record(0, 0, 0, 1, 0, 0, 40.0, 0, true);
        LevelScale scale = one.toRays().scale();
        assertThat(scale.low()).isLessThan(scale.high());
        assertThat(scale.high()).isGreaterThanOrEqualTo(40.0);
        assertThat(new RayCollector("a", "b", 8.0).toRays().scale().high()).isEqualTo(60.0);

        RayCollector wide = new RayCollector("microphone", "drone", 8.0);
        wide.record(0, 0, 0, 1, 0, 0, 61.0, 0, true);
        wide.record(0, 0, 0, 1, 0, 0, -80.0, 0, true);
        wide.record(0, 0, 0, 1, 0, 0, Double.NEGATIVE_INFINITY, 0, true);
        LevelScale all = wide.toRays().scale();
        assertThat(all.high()).isEqualTo(65.0);
        assertThat(all.low()).isEqualTo(5.0);
        assertThat(all.colour(-80)).isEqualTo(all.colour(5)).isNotEqualTo(all.colour(65));
    }
}
