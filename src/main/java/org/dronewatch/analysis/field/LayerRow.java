package org.dronewatch.analysis.field;

import java.util.Arrays;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.AssessmentBounds;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.Cause;

/** One row of cells of a {@link SensorLayer} while it is assessed. One thread at a time. */
final class LayerRow {
    private final FieldProbe probe;
    private final Assessor assessor;
    private final int courses;
    private final int[] entries;
    private final int[] codes;

    /** For each course the first one on which the sensor certainly answers the same. */
    private final int[] alikes;

    private byte[] pool = new byte[0];
    private int used;

    LayerRow(int columns, FieldProbe probe, Assessor assessor) {
        this.probe = probe;
        this.assessor = assessor;
        this.courses = probe.courses().size();
        this.entries = new int[columns];
        this.codes = new int[courses];
        this.alikes = IntStream.range(0, courses).map(probe::alike).toArray();
    }

    /** Assesses the drone in a cell, with its middle at a place, m. */
    void set(int column, Position at) {
        if (probe.search().isPresent()) {
            search(column, at, probe.search().get());
            return;
        }
        Optional<Pointing> pointing = probe.pointing(at);
        OptionalInt certain = code(assessor.boundAtAllHeadings(probe.drone(), at, pointing));
        if (certain.isPresent()) {
            entries[column] = certain.getAsInt();
            return;
        }
        codes[0] = code(at, 0, pointing);
        boolean alike = true;
        if (courses > 1 && !assessor.isSameAtAllHeadings(probe.drone(at, 0), pointing)) {
            for (int course = 1; course < courses; course++) {
                codes[course] = alikes[course] < course ? codes[alikes[course]] : code(at, course, pointing);
                alike &= codes[course] == codes[0];
            }
        }
        entries[column] = alike ? codes[0] : -1 - keep();
    }

    /** Over one period of the sensor's search. */
    private void search(int column, Position at, SearchPeriod period) {
        CellPointings pointings = period.at(at, probe.drone().radius());
        boolean alike = true;
        for (int course = 0; course < courses; course++) {
            Drone there = probe.drone(at, course);
            codes[course] = code(probe.lookInSteps(assessor, there, pointings));
            alike &= codes[course] == codes[0];
            if (course == 0 && pointings.isSameAtAllHeadings(assessor, there)) {
                break;
            }
        }
        entries[column] = alike ? codes[0] : -1 - keep();
    }

    private static int code(CellLook look) {
        Cause cause = look.assessment().cause();
        return CellCode.of(cause == Cause.UNKNOWN ? 0 : CellCode.steps(look.probability()), cause);
    }

    /** Where bounds are too far apart, the drone is assessed. */
    private int code(Position at, int course, Optional<Pointing> pointing) {
        FlightState state = probe.state(at, course);
        OptionalInt certain = code(assessor.bound(probe.drone(), state, pointing, probe::steps));
        return certain.isPresent()
                ? certain.getAsInt()
                : code(probe.assessInSteps(assessor, probe.drone().at(state), pointing));
    }

    /** Empty where bounds are more than a step apart. */
    private OptionalInt code(Optional<AssessmentBounds> found) {
        if (found.isEmpty()) {
            return OptionalInt.empty();
        }
        AssessmentBounds bounds = found.get();
        int steps = probe.steps(bounds.least());
        return steps == probe.steps(bounds.greatest())
                ? OptionalInt.of(CellCode.of(steps, bounds.cause()))
                : OptionalInt.empty();
    }

    /** A sensor whose line of sight leaves the known ground is not counted on. */
    private int code(Assessment assessment) {
        Cause cause = assessment.cause();
        return CellCode.of(cause == Cause.UNKNOWN ? 0 : probe.steps(assessment.probability()), cause);
    }

    /** Takes over what was assessed before. */
    void take(int column, LayerSlice former, int row) {
        int entry = former.entries()[row][column];
        if (entry >= 0) {
            entries[column] = entry;
            return;
        }
        for (int course = 0; course < courses; course++) {
            codes[course] = CellCode.at(former.byCourse()[row], -1 - entry + 2 * course);
        }
        entries[column] = -1 - keep();
    }

    private int keep() {
        int at = used;
        if (pool.length < used + 2 * courses) {
            pool = Arrays.copyOf(pool, 2 * pool.length + 2 * courses);
        }
        for (int course = 0; course < courses; course++) {
            CellCode.put(pool, used, codes[course]);
            used += 2;
        }
        return at;
    }

    /** Its entries, as in {@link SensorLayer}. */
    int[] entries() {
        return entries;
    }

    /** A copy of the bytes of those cells whose courses are not alike. */
    byte[] byCourse() {
        return Arrays.copyOf(pool, used);
    }
}
