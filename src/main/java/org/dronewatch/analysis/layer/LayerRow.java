package org.dronewatch.analysis.layer;

import java.util.Arrays;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import org.dronewatch.analysis.cell.CellCode;
import org.dronewatch.analysis.cell.MarginCode;
import org.dronewatch.analysis.cell.ProbabilityStep;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.AssessmentBounds;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.Cause;

/** One row of cells of a {@link SensorLayer} while it is assessed. Not thread-safe. */
public final class LayerRow {
    private final FieldProbe probe;
    private final Assessor assessor;
    private final int courses;
    private final int[] entries;
    private final int[] codes;

    /** For each course the first one on which the sensor certainly answers the same. */
    private final int[] alikes;

    private byte[] pool = new byte[0];
    private int used;

    /**
     * A row in which nothing has been assessed yet.
     *
     * @param columns number of cells in the row
     * @param assessor assessor of the probe's sensor for this thread; null if the row only takes over known codes
     */
    public LayerRow(int columns, FieldProbe probe, Assessor assessor) {
        this.probe = probe;
        this.assessor = assessor;
        this.courses = probe.courses().size();
        this.entries = new int[columns];
        this.codes = new int[courses];
        this.alikes = IntStream.range(0, courses).map(probe::alike).toArray();
    }

    /** Assesses the drone in a cell with its centre at a position, m. */
    void set(int column, Position at) {
        entries[column] = assess(at) ? codes[0] : -1 - keep();
    }

    /**
     * The {@link CellCode}s of the drone at a position, m: a single one if all courses give the same, otherwise one for
     * each course.
     */
    public int[] codesAt(Position at) {
        return assess(at) ? new int[] {codes[0]} : codes.clone();
    }

    /**
     * The codes of the drone at a position, m, at which former codes are known, after some of the courses have changed.
     *
     * @param former the former codes, as {@link #codesAt(Position)} gave them
     * @param changed the numbers of the courses that have changed
     */
    public int[] codesAt(Position at, int[] former, int[] changed) {
        Optional<Pointing> pointing = probe.pointing(at);
        boolean isSame = probe.search().isEmpty()
                && former.length == 1
                && (code(assessor.boundAtAllHeadings(probe.drone(), at, pointing))
                                .isPresent()
                        || assessor.isSameAtAllHeadings(probe.drone(at, 0), pointing));
        if (isSame) {
            return former;
        }
        if (probe.search().isPresent()) {
            return codesAt(at);
        }
        for (int course = 0; course < courses; course++) {
            codes[course] = former[former.length == 1 ? 0 : course];
        }
        for (int course : changed) {
            codes[course] = code(at, course, pointing);
        }
        boolean alike = IntStream.of(codes).allMatch(code -> code == codes[0]);
        return alike ? new int[] {codes[0]} : codes.clone();
    }

    /** Takes over codes, as {@link #codesAt} gives them. */
    void set(int column, int[] known) {
        if (known.length == 1) {
            entries[column] = known[0];
            return;
        }
        System.arraycopy(known, 0, codes, 0, courses);
        entries[column] = -1 - keep();
    }

    /** Finds the codes; returns whether the code of the first course holds for all courses. */
    private boolean assess(Position at) {
        if (probe.search().isPresent()) {
            return search(at, probe.search().get());
        }
        Optional<Pointing> pointing = probe.pointing(at);
        OptionalInt certain = code(assessor.boundAtAllHeadings(probe.drone(), at, pointing));
        if (certain.isPresent()) {
            codes[0] = certain.getAsInt();
            return true;
        }
        codes[0] = code(at, 0, pointing);
        boolean alike = true;
        if (courses > 1 && !assessor.isSameAtAllHeadings(probe.drone(at, 0), pointing)) {
            for (int course = 1; course < courses; course++) {
                codes[course] = alikes[course] < course ? codes[alikes[course]] : code(at, course, pointing);
                alike &= codes[course] == codes[0];
            }
        }
        return alike;
    }

    /** The same as {@link #assess}, over one period of the sensor's search. */
    private boolean search(Position at, SearchPeriod period) {
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
        return alike;
    }

    private int code(CellLook look) {
        Assessment assessment = look.assessment();
        return code(ProbabilityStep.of(look.probability()), assessment.cause(), margin(assessment));
    }

    /** Where bounds are too far apart, the drone is assessed. */
    private int code(Position at, int course, Optional<Pointing> pointing) {
        FlightState state = probe.state(at, course);
        Optional<AssessmentBounds> bounds =
                assessor.bound(probe.drone(), state, pointing, probe::steps).filter(this::isDecisive);
        if (bounds.isPresent()) {
            Cause cause = bounds.get().cause();
            return code(probe.steps(bounds.get().least()), cause, margin(cause, state, pointing));
        }
        Assessment exact = probe.assessInSteps(assessor, probe.drone().at(state), pointing);
        int margin = assessor.isBounding() ? margin(exact.cause(), state, pointing) : margin(exact);
        return code(probe.steps(exact.probability()), exact.cause(), margin);
    }

    /** Empty where bounds are more than a step apart. */
    private OptionalInt code(Optional<AssessmentBounds> found) {
        if (found.isEmpty() || !isDecisive(found.get())) {
            return OptionalInt.empty();
        }
        AssessmentBounds bounds = found.get();
        return OptionalInt.of(code(probe.steps(bounds.least()), bounds.cause(), margin(bounds)));
    }

    private boolean isDecisive(AssessmentBounds bounds) {
        return probe.steps(bounds.least()) == probe.steps(bounds.greatest());
    }

    /** A sensor whose line of sight leaves the known ground is not counted on. */
    private static int code(int steps, Cause cause, int margin) {
        return cause == Cause.UNKNOWN
                ? CellCode.of(0, Cause.UNKNOWN, MarginCode.NOTHING)
                : CellCode.of(steps, cause, margin);
    }

    private static int margin(AssessmentBounds bounds) {
        return MarginCode.between(bounds.leastMarginDb(), bounds.greatestMarginDb(), bounds.cause() == Cause.DETECTED);
    }

    /**
     * The margin of a sensor that bounds its assessments: whether bounds decide in a state, and which, depends on the
     * masks that were made for earlier cells, so that only what holds in any case is kept.
     */
    private int margin(Cause cause, FlightState state, Optional<Pointing> pointing) {
        return cause == Cause.DETECTED
                ? MarginCode.atLeast(0.0)
                : MarginCode.atMost(Math.min(0.0, assessor.greatestMarginDb(probe.drone(), state, pointing)));
    }

    /**
     * The margin of an assessment; only its sign for estimates from some looks, and for cameras, which do not count all
     * pixels that show a drone.
     */
    private int margin(Assessment assessment) {
        boolean isDetected = assessment.signal().isDetected();
        if (assessment.probabilityError() > 0.0 || assessor.isBounding() && isDetected) {
            return isDetected ? MarginCode.atLeast(0.0) : MarginCode.atMost(0.0);
        }
        return MarginCode.of(assessment.marginDb());
    }

    /** Takes over what was assessed before. */
    void take(int column, LayerSlice former, int row) {
        int entry = former.entries()[row][column];
        if (entry >= 0) {
            entries[column] = entry;
            return;
        }
        for (int course = 0; course < courses; course++) {
            codes[course] = CourseCodes.at(former.byCourse()[row], -1 - entry, course);
        }
        entries[column] = -1 - keep();
    }

    private int keep() {
        int at = used;
        int most = used + CourseCodes.most(courses);
        if (pool.length < most) {
            pool = Arrays.copyOf(pool, 2 * pool.length + most);
        }
        used = CourseCodes.put(pool, at, codes);
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
