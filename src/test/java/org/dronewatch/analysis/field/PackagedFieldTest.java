package org.dronewatch.analysis.field;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import org.dronewatch.drone.Drone;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.Observation;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Fields of real scenes against looks at random cells: where a probability is stored as 0 or 1, a look gives the same
 * answer, also where levels of sound are interpolated; and the cause is that of {@link BruteCauses}. With
 * {@code -Ddronewatch.field=run} all scenes and 2,000 cells of nearly each, otherwise the fastest and fewer.
 */
class PackagedFieldTest {
    private static final boolean ALL = "run".equals(System.getProperty("dronewatch.field"));

    /** How many cells the build looks at. */
    private static final int SHORT = 200;

    /** Brute force may leave open at most this part of the causes. */
    private static final double UNDECIDED = 0.05;

    @ParameterizedTest
    @CsvSource({
        "scenes/hill-radar.yaml, quadrotor, 1000, 40,,,, 2000",
        "acoustic-range, quadrotor, 800, 32,,,, 2000",
        "camera-range, quadrotor, 500, 20,,,, 2000",
        "closed-space, quadrotor, 60, 2, 1 3 6 10 15,,, 2000",
        "multi-sensor, quadrotor, 400, 8,,,, 2000",
        "scenes/birds.yaml, intruder, 1200, 40,,,, 2000",
        "scenes/cued-camera.yaml, intruder, 1200, 40,,,, 2000",
        "scenes/daylight.yaml, quadrotor, 250, 10,,,, 2000",
        "scenes/false-alarms.yaml, intruder, 1200, 40,,,, 2000",
        "scenes/glider.yaml, glider, 1200, 40,,,, 2000",
        "scenes/meadow.yaml, intruder, 3000, 100,,,, 2000",
        "scenes/monaco.yaml, from-the-sea, 3600, 120,,,, 2000",
        "scenes/palace.yaml, intruder, 3600, 120,,,, 2000",
        "scenes/radar-clutter.yaml, coming, 1200, 40,,,, 2000",
        // Microphones in the energy model, whose levels are interpolated; in the church, a look takes half a second.
        "scenes/monaco.yaml, from-the-sea, 500, 5,, microphone,, 2000",
        "multi-sensor, quadrotor, 400, 8,, microphone, sensors.microphone.propagation=energy-model, 2000",
        "closed-space, quadrotor, 60, 1, 1 3 6 10 15, microphone, sensors.microphone.propagation=energy-model, 100",
    })
    void whereAFieldIsCertainALookAgrees(
            String name,
            String drone,
            double side,
            double cell,
            String heights,
            String sensorAlone,
            String set,
            int cells) {
        assumeTrue(ALL || name.endsWith("hill-radar.yaml"));
        PackagedSite site = PackagedSite.of(name, drone, side, cell, heights, FieldTerms.ONE_LOOK, sensorAlone, set);
        BruteCauses causes = new BruteCauses(site);
        long seed = Long.getLong("dronewatch.field.seed", System.nanoTime());
        System.out.println("PackagedFieldTest: seed " + seed);
        Map<Cause, Integer> met = new EnumMap<>(Cause.class);
        int certain = 0;
        int undecided = 0;
        int all = 0;
        for (PackagedSite.Cell each : site.cells(ALL ? cells : SHORT, new Random(seed))) {
            Drone there = site.at(each);
            for (int sensor = 0; sensor < site.field().sensors().size(); sensor++) {
                String id = site.field().sensors().get(sensor);
                String where = String.format("seed %d, %s of %s, %s at %s", seed, id, name, each, there.origin());
                Cause cause = site.field().cause(sensor, each.height(), each.column(), each.row(), each.course());
                double stored =
                        site.field().probability(sensor, each.height(), each.column(), each.row(), each.course());
                Optional<Observation> seen = site.look(id, there);
                if (cause != Cause.UNKNOWN && (stored == 0.0 || stored == 1.0)) {
                    certain++;
                    assertThat(seen.filter(one -> isDetected(site, id, one)).isPresent())
                            .as(where)
                            .isEqualTo(stored == 1.0);
                }
                Set<Cause> possible = causes.of(id, there, seen, stored);
                assertThat(possible).as(where).contains(cause);
                all++;
                undecided += possible.size() > 1 ? 1 : 0;
                met.merge(cause, 1, Integer::sum);
            }
        }
        site.field()
                .interpolated()
                .forEach((id, error) -> System.out.println(id + ": error of " + error.percentile95() + " dB"));
        System.out.println(name + ": " + all + " assessments, " + certain + " certain, cause undecided by brute force "
                + undecided + ", " + met);
        assertThat(certain).isGreaterThan(all / 2);
        // Brute force must decide nearly all causes; of a few cells, more may be open by chance (four standard
        // deviations).
        double open = UNDECIDED * all;
        assertThat((double) undecided).as("undecided, seed %d", seed).isLessThan(open + 4.0 * Math.sqrt(open));
        assertThat(met.keySet()).isNotEqualTo(EnumSet.of(Cause.DETECTED));
    }

    /** Whether a look detects; for an observer, whether he is able to, given time. */
    private static boolean isDetected(PackagedSite site, String id, Observation seen) {
        return site.sensor(id).chance() == Chance.PER_ENCOUNTER ? seen.probability() == 1.0 : seen.isDetected();
    }
}
