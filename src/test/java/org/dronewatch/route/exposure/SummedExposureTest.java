package org.dronewatch.route.exposure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.BitSet;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeMap;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.search.PlanDirections;
import org.dronewatch.route.search.PointExposure;
import org.dronewatch.route.search.RouteGrid;
import org.dronewatch.route.search.RouteMode;
import org.dronewatch.route.search.RouteProblem;
import org.dronewatch.route.search.RouteSearch;
import org.junit.jupiter.api.Test;

/** Sensors at random places, of which each adds to the least exposure, in whichever order they are given. */
class SummedExposureTest {
    @Test
    void theOrderOfSensorsDoesNotMatterAndEachAddsExposure() {
        long seed = 4713;
        SplittableRandom random = new SplittableRandom(seed);
        RouteGrid grid = RouteGrid.level(0.0, 0.0, 10.0, 21, 21, 10.0, 30.0);
        BitSet starts = new BitSet();
        starts.set(grid.node(0, 0, 0));
        BitSet goals = new BitSet();
        goals.set(grid.node(20, 20, 1));
        for (int i = 0; i < 10; i++) {
            Map<String, ExposureField> sensors = new HashMap<>();
            double before = 0.0;
            for (int sensor = 0; sensor < 6; sensor++) {
                Position at = new Position(200.0 * random.nextDouble(), 200.0 * random.nextDouble(), 0.0);
                sensors.put("sensor " + sensor, new PointExposure(at, 100.0 * random.nextDouble(), 2));
                double now = least(grid, sensors, starts, goals);
                assertThat(now).as("seed %d", seed).isGreaterThan(before);
                before = now;
            }
            Map<String, ExposureField> backwards = new TreeMap<>(Comparator.reverseOrder());
            backwards.putAll(sensors);
            assertThat(least(grid, backwards, starts, goals)).isEqualTo(before);
        }
    }

    private static double least(RouteGrid grid, Map<String, ExposureField> sensors, BitSet starts, BitSet goals) {
        RouteProblem problem = new RouteProblem(
                grid,
                ExposureField.ofSensors(sensors),
                List.of(RouteMode.free("flight", 10.0)),
                0.0,
                PlanDirections.of(16),
                starts,
                goals);
        return RouteSearch.toGoals(problem).cost(starts.nextSetBit(0));
    }
}
