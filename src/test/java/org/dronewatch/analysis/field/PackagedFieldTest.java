package org.dronewatch.analysis.field;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.drone.Drone;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.Observation;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Fields of real scenes against looks at random cells: where a probability is stored as 0 or 1, a look gives the same
 * answer, also where levels of sound are interpolated; and the cause is that of {@link BruteCauses}. With
 * {@code -Ddronewatch.field=run} all scenes and 2,000 cells of nearly each, with {@code -Ddronewatch.field=monaco}
 * those whose name contains that, and with {@code -Ddronewatch.field.sensor=ID} one of their sensors alone; otherwise
 * the fastest and fewer cells.
 */
class PackagedFieldTest {
    private static final Optional<String> LONG = Optional.ofNullable(System.getProperty("dronewatch.field"));

    /** The sensor that is left on in the long form; all if null. */
    private static final String SENSOR = System.getProperty("dronewatch.field.sensor");

    /** The time between two lines that state how far the long form has come, ns. */
    private static final long BETWEEN_LINES = 20_000_000_000L;

    /** How many cells the build looks at. */
    private static final int SHORT = 200;

    /** Brute force may leave open at most this part of the causes. */
    private static final double UNDECIDED = 0.05;

    @ParameterizedTest(name = "{0} {5}")
    @CsvSource({
        "scenes/hill-radar.yaml, quadrotor, 1000, 40,,,, 2000",
        "acoustic-range, quadrotor, 800, 32,,,, 2000",
        "camera-range, quadrotor, 500, 20,,,, 2000",
        "closed-space, quadrotor, 60, 1.5, 1 3 6 10 15,,, 2000",
        "multi-sensor, quadrotor, 400, 8,,,, 2000",
        "scenes/birds.yaml, intruder, 1200, 40,,,, 2000",
        "scenes/cued-camera.yaml, intruder, 1200, 40,,,, 2000",
        "scenes/daylight.yaml, quadrotor, 250, 10,,,, 2000",
        "scenes/false-alarms.yaml, intruder, 1200, 40,,,, 2000",
        "scenes/glider.yaml, glider, 1200, 40,,,, 2000",
        "scenes/listening-post.yaml, intruder, 1200, 40,,,, 2000",
        "scenes/meadow.yaml, intruder, 3000, 100,,,, 2000",
        "scenes/monaco.yaml, from-the-sea, 3600, 120,,,, 2000",
        "scenes/palace.yaml, intruder, 3600, 120,,,, 2000",
        "scenes/radar-clutter.yaml, coming, 1200, 40,,,, 2000",
        // Microphones in the energy model, whose levels are interpolated; in the church, a look takes half a second.
        "scenes/monaco.yaml, from-the-sea, 500, 5,, microphone,, 2000",
        "multi-sensor, quadrotor, 80, 1, 10 20 30, microphone, sensors.microphone.propagation=energy-model, 2000",
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
        boolean isLong =
                LONG.filter(part -> part.equals("run") || name.contains(part)).isPresent();
        assumeTrue(isLong || LONG.isEmpty() && name.endsWith("hill-radar.yaml"));
        String alone = sensorAlone == null ? SENSOR : sensorAlone;
        assumeTrue(SENSOR == null || SENSOR.equals(alone));
        long begin = System.nanoTime();
        long seed = Long.getLong("dronewatch.field.seed", begin);
        print(name + (alone == null ? "" : ", " + alone) + ": seed " + seed);
        PackagedSite site = PackagedSite.of(name, drone, side, cell, heights, FieldTerms.ONE_LOOK, alone, set);
        print("    field after " + seconds(begin) + " s");
        BruteCauses causes = new BruteCauses(site);
        Map<Cause, Integer> met = new EnumMap<>(Cause.class);
        Map<String, Integer> open = new TreeMap<>();
        int certain = 0;
        int all = 0;
        int visited = 0;
        long line = System.nanoTime();
        List<PackagedSite.Cell> looked = site.cells(isLong ? cells : SHORT, new Random(seed));
        for (PackagedSite.Cell each : looked) {
            if (System.nanoTime() - line > BETWEEN_LINES) {
                line = System.nanoTime();
                print("    " + visited + " of " + looked.size() + " cells after " + seconds(begin) + " s");
            }
            visited++;
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
                if (possible.size() > 1) {
                    open.merge(site.sensor(id).kind() + " " + possible, 1, Integer::sum);
                }
                met.merge(cause, 1, Integer::sum);
            }
        }
        site.field()
                .interpolated()
                .forEach((id, error) -> print("    " + id + ": error of " + error.percentile95() + " dB"));
        int undecided = open.values().stream().mapToInt(Integer::intValue).sum();
        print(name + ": " + all + " assessments, " + certain + " certain, " + met + ", cause undecided by brute force "
                + undecided + " " + open + ", after " + seconds(begin) + " s");
        assertThat(certain).isGreaterThan(all / 2);
        // Brute force must decide nearly all causes; of a few cells, more may be open by chance (four standard
        // deviations).
        double most = UNDECIDED * all;
        assertThat((double) undecided).as("undecided, seed %d", seed).isLessThan(most + 4.0 * Math.sqrt(most));
        assertThat(met.keySet()).isNotEqualTo(EnumSet.of(Cause.DETECTED));
    }

    private static void print(String line) {
        System.out.println(line);
        System.out.flush();
    }

    private static long seconds(long since) {
        return Math.round((System.nanoTime() - since) * 1e-9);
    }

    /** Whether a look detects; for an observer, whether he is able to, given time. */
    private static boolean isDetected(PackagedSite site, String id, Observation seen) {
        return site.sensor(id).chance() == Chance.PER_ENCOUNTER ? seen.probability() == 1.0 : seen.isDetected();
    }
}
