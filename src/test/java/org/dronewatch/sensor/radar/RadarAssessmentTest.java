package org.dronewatch.sensor.radar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.sensor.Walls.assess;
import static org.dronewatch.sensor.Walls.behind;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.look;
import static org.dronewatch.sensor.Walls.open;
import static org.dronewatch.sensor.Walls.wall;

import java.util.List;
import java.util.SplittableRandom;
import org.dronewatch.Wilson;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.radar.LinkBudget.Hardware;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What a radar has of a drone before chance decides, and why that is not enough. */
class RadarAssessmentTest {
    private static final Hardware BUDGET = new Hardware(4, 33, 0.02, 10e6, 0, 0);
    private static final RadarSettings RADAR = RadarSettings.at(new Position(0, 0, 0), BUDGET)
            .withFieldOfView(Math.toRadians(60), Math.toRadians(20))
            .withRanges(20, 20_000);

    /** A drone that comes straight towards the radar at a speed in m/s. */
    private static Drone coming(Position place, double speed) {
        return cube(place, place.times(-speed / place.length()));
    }

    @ParameterizedTest
    @CsvSource({
        "0, 1000, 0, 10, DETECTED,",
        "0, 20001, 0, 10, OUT_OF_RANGE, 20000",
        "0, 19, 0, 10, OUT_OF_RANGE, 20",
        "1000, 1000, 0, 10, OUT_OF_VIEW,",
        "0, 1000, 300, 10, OUT_OF_VIEW,",
        "0, 1000, 0, 0.5, TOO_SLOW, 1",
        "0, 1000, 0, 201, TOO_FAST, 200",
        "0, 15000, 0, 10, TOO_WEAK,",
        // Two at once: the first in order counts.
        "20001, 20001, 0, 0, OUT_OF_RANGE, 20000",
        "1000, 1000, 0, 0, OUT_OF_VIEW,",
        "0, 15000, 0, 0, TOO_SLOW, 1"
    })
    void theFirstCauseCounts(double x, double y, double z, double speed, Cause cause, Double limit) {
        Assessment one = assess(RADAR, open(), coming(new Position(x, y, z), speed));

        assertThat(one.cause()).isEqualTo(cause);
        assertThat(one.limit().stream().boxed().toList()).isEqualTo(limit == null ? List.of() : List.of(limit));
        assertThat(one.probability()).isEqualTo(cause == Cause.DETECTED ? 1.0 : 0.0);
    }

    @ParameterizedTest
    @EnumSource(ModelRole.class)
    void aDroneBehindAWallIsHiddenByItsModelUnlessItIsTooSlowOutOfViewOrOutOfRange(ModelRole role) {
        World world = behind(wall(500, -99, 99), role);
        Position behind = new Position(0, 1000, 0);

        Assessment hidden = assess(RADAR, world, coming(behind, 10));
        assertThat(hidden.cause()).isEqualTo(Cause.hiddenBy(role));
        assertThat(hidden.obstacle().orElseThrow().model().file()).isEqualTo("wall.obj");
        assertThat(hidden.margin()).isEqualTo(Double.NEGATIVE_INFINITY);
        assertThat(assess(RADAR, world, coming(new Position(0, 15_000, 0), 10)).cause())
                .as("nothing of it is visible, though it would be too weak")
                .isEqualTo(Cause.hiddenBy(role));
        assertThat(assess(RADAR, world, coming(behind, 0)).cause()).isEqualTo(Cause.TOO_SLOW);
        assertThat(assess(RADAR, world, coming(new Position(0, 1000, 400), 10)).cause())
                .isEqualTo(Cause.OUT_OF_VIEW);
        assertThat(assess(RADAR, world, coming(new Position(0, 30_000, 0), 10)).cause())
                .isEqualTo(Cause.OUT_OF_RANGE);
    }

    /** In part hidden, a drone counts for what shows: 4 of 9 points of its box, 3.5 dB less. */
    @Test
    void halfADroneIsHiddenOnlyWhereTheWholeWouldBeDetected() {
        World world = behind(wall(500, -99, 0), ModelRole.BUILDING);
        double reach = 1000 * Math.pow(10, (BUDGET.signalToNoise(RADAR.frequency(), 0.01, 1000) - 15.0) / 40.0);

        Assessment detected = assess(RADAR, world, coming(new Position(0, 0.6 * reach, 0), 10));
        assertThat(detected.cause()).isEqualTo(Cause.DETECTED);
        Assessment hidden = assess(RADAR, world, coming(new Position(0, 0.95 * reach, 0), 10));
        assertThat(hidden.cause()).isEqualTo(Cause.HIDDEN_BY_BUILDING);
        assertThat(hidden.quantity()).isFinite();
        Assessment weak = assess(RADAR, world, coming(new Position(0, 1.05 * reach, 0), 10));
        assertThat(weak.cause()).isEqualTo(Cause.TOO_WEAK);
    }

    @Test
    void theMarginIsThatOfTheRadarEquation() {
        Assessment one = assess(RADAR, open(), coming(new Position(0, 15_000, 0), 10));

        assertThat(one.margin()).isCloseTo(BUDGET.signalToNoise(10e9, 0.01, 15_000) - 15.0, within(1e-9));
        assertThat(one.marginDb()).isEqualTo(one.margin());
        assertThat(one.unit()).isEqualTo("dB");
    }

    @ParameterizedTest
    @ValueSource(doubles = {11_500, 12_500, 14_000})
    void byChanceItDetectsAsOftenAsItsProbabilitySays(double distance) {
        RadarSettings radar = RADAR.withDetection(RadarDetection.Chance.DEFAULT);
        Drone drone = coming(new Position(0, distance, 0), 10);
        Assessment one = assess(radar, open(), drone);
        int hits = 0;
        for (int i = 0; i < 1000; i++) {
            Observation look = look(radar, open(), drone, i);
            assertThat(look.value()).isEqualTo(one.quantity());
            assertThat(look.probability()).isEqualTo(one.probability());
            hits += look.isDetected() ? 1 : 0;
        }
        double[] interval = Wilson.interval(hits, 1000, 3.3);
        assertThat(one.probability()).isBetween(interval[0], interval[1]).isBetween(0.01, 0.99);
        assertThat(one.cause()).isEqualTo(one.probability() >= 0.5 ? Cause.DETECTED : Cause.TOO_WEAK);
    }

    @Test
    void aLookAndAnAssessmentAgreeToTheLastBit() {
        SplittableRandom random = new SplittableRandom(3);
        World world = behind(wall(300, -99, 5), ModelRole.TERRAIN);
        for (int i = 0; i < 100; i++) {
            Position place =
                    new Position(random.nextDouble(-500, 500), random.nextDouble(10, 9000), random.nextDouble(0, 200));
            Drone drone = coming(place, random.nextDouble(0, 5));
            Observation look = look(RADAR, world, drone, i);
            Assessment one = assess(RADAR, world, drone);
            assertThat(one.quantity()).isEqualTo(look.value());
            assertThat(one.threshold()).isEqualTo(look.threshold());
            assertThat(one.probability()).isEqualTo(look.probability());
            assertThat(one.cause() == Cause.DETECTED).isEqualTo(look.isDetected());
        }
    }
}
