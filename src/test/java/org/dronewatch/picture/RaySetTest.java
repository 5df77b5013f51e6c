package org.dronewatch.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RaySetTest {
    @TempDir
    private Path directory;

    @Test
    void aPathThatReachedTheSensorIsHeardFromItsBeginningOn() {
        RaySet rays = new RaySet("microphone", "drone");
        rays.record(0, 0, 0, 10, 0, 0, 50, 0, false);
        rays.record(0, 0, 0, 0, 10, 0, 50, 0, false);
        rays.record(10, 0, 0, 10, 10, 0, 45, 1, false);
        rays.record(10, 0, 0, 20, 10, 0, 44, 1, false);
        rays.record(10, 10, 0, 0, 20, 0, 40, 2, true);
        rays.record(0, 0, 0, 0, 20, 0, 48, 0, true);

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
        RaySet rays = new RaySet("microphone", "quadrotor");
        assertThat(stage.traceRays(8.0, "microphone", "quadrotor", rays)).isTrue();
        assertThat(stage.traceRays(8.0, "camera", "quadrotor", rays)).isFalse();
        assertThat(stage.traceRays(8.0, "microphone", "nobody", rays)).isFalse();

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

    @Test
    void moreThanCanBeKeptIsCounted() {
        RaySet rays = new RaySet("microphone", "drone");
        for (int i = 0; i < RaySet.MOST + 5; i++) {
            rays.record(0, 0, 0, 1, 1, i, 50, 0, false);
        }
        assertThat(rays.count()).isEqualTo(RaySet.MOST);
        assertThat(rays.leftOut()).isEqualTo(5);
    }

    @Test
    void aScaleHoldsAllLevelsAndItsEndsDiffer() {
        RaySet one = new RaySet("microphone", "drone");
        one.record(0, 0, 0, 1, 0, 0, 40.0, 0, true);
        LevelScale scale = LevelScale.of(one);
        assertThat(scale.low()).isLessThan(scale.high());
        assertThat(scale.high()).isGreaterThanOrEqualTo(40.0);
        assertThat(LevelScale.of(new RaySet("a", "b")).high()).isEqualTo(60.0);

        RaySet wide = new RaySet("microphone", "drone");
        wide.record(0, 0, 0, 1, 0, 0, 61.0, 0, true);
        wide.record(0, 0, 0, 1, 0, 0, -80.0, 0, true);
        wide.record(0, 0, 0, 1, 0, 0, Double.NEGATIVE_INFINITY, 0, true);
        LevelScale all = LevelScale.of(wide);
        assertThat(all.high()).isEqualTo(65.0);
        assertThat(all.low()).isEqualTo(5.0);
        assertThat(all.colour(-80)).isEqualTo(all.colour(5)).isNotEqualTo(all.colour(65));
    }
}
