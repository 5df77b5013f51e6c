package org.dronewatch.analysis.layer;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Function;
import java.util.random.RandomGenerator;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.dronewatch.analysis.cell.CellCode;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.cell.ProbabilityStep;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Draws;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.ProbabilityResolution;
import org.dronewatch.sensor.RaySensor;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.Signal;
import org.dronewatch.sensor.SoundTracing;
import org.dronewatch.world.World;

/**
 * One sensor, and a drone that can be put at any position on any of several courses.
 *
 * @param world the site
 * @param drone the drone, at any position
 * @param sensor name of the sensor
 * @param settings settings of the sensor
 * @param seed seed of the run, for sensors that trace random rays
 * @param courses courses of the drone
 * @param terms terms on which the drone counts as detected
 * @param search where the sensor points while it searches; empty if its search does not matter
 * @param assessor assessor of the sensor; each thread has its own, equivalent assessor ({@link #newAssessor})
 * @param shortcuts what an assessment may leave out
 */
public record FieldProbe(
        World world,
        Drone drone,
        String sensor,
        SensorSettings<?> settings,
        long seed,
        List<Course> courses,
        FieldTerms terms,
        Optional<SearchPeriod> search,
        Assessor assessor,
        Shortcuts shortcuts) {
    private static final double EVEN_CHANCE = 0.5;

    /**
     * What an assessment may leave out.
     *
     * @param excess the values that are interpolated between cells; empty if each cell is assessed
     * @param isExactAlone for a signal that could be interpolated, whether to count only the part that arrives along
     *     deterministic paths, which are found without random rays: this is much faster, and never overstates the
     *     signal
     * @param needed the step of the probability that has to be reached, if nothing else matters: a result that is the
     *     same on all courses then shows reliably only whether the probability reaches this step
     */
    public record Shortcuts(Optional<ExcessMap> excess, boolean isExactAlone, OptionalInt needed) {
        static final Shortcuts NONE = new Shortcuts(Optional.empty(), false, OptionalInt.empty());
    }

    /** A probe that assesses each cell; the sensor searches if the terms say so. */
    public FieldProbe(
            World world,
            Drone drone,
            String sensor,
            SensorSettings<?> settings,
            long seed,
            List<Course> courses,
            FieldTerms terms) {
        this(
                world,
                drone,
                sensor,
                settings,
                seed,
                courses,
                terms,
                terms.pointing() == FieldTerms.Turning.SEARCH ? SearchPeriod.of(settings, terms) : Optional.empty(),
                new Assessor(sensor, settings, world),
                Shortcuts.NONE);
    }

    private FieldProbe with(Shortcuts others) {
        return new FieldProbe(world, drone, sensor, settings, seed, courses, terms, search, assessor, others);
    }

    /** A copy of this probe that interpolates between cells or, if there is no map, assesses each cell. */
    public FieldProbe with(Optional<ExcessMap> map) {
        return with(new Shortcuts(map, false, needed()));
    }

    /**
     * A copy of this probe, whose signal could be interpolated, that counts only what arrives along deterministic
     * paths.
     */
    public FieldProbe onExactPaths() {
        return with(new Shortcuts(Optional.empty(), true, needed()));
    }

    /**
     * A copy of this probe that only decides whether the probability reaches a step; this probe itself for a sensor
     * that does not trace sound, since such a sensor takes little longer for the full answer, which serves for every
     * step.
     *
     * @param step the step to be reached, above 0 and at most {@link ProbabilityStep#CERTAIN}
     */
    public FieldProbe deciding(int step) {
        return settings.as(SoundTracing.class).isEmpty()
                ? this
                : with(new Shortcuts(excess(), isExactAlone(), OptionalInt.of(step)));
    }

    /** A copy of this probe with other courses, as many as before. */
    public FieldProbe on(List<Course> others) {
        return new FieldProbe(world, drone, sensor, settings, seed, others, terms, search, assessor, shortcuts);
    }

    /** The values that are interpolated between cells; empty if each cell is assessed. */
    public Optional<ExcessMap> excess() {
        return shortcuts.excess();
    }

    /** Whether only what arrives along deterministic paths counts. */
    public boolean isExactAlone() {
        return shortcuts.isExactAlone();
    }

    /** The step that the probability has to reach, if nothing else matters. */
    OptionalInt needed() {
        return shortcuts.needed();
    }

    /** An assessor for one thread. */
    public Assessor newAssessor() {
        return assessor.sibling();
    }

    /** The drone at a position, m, on a course given by its number. */
    public Drone drone(Position at, int course) {
        return drone.at(state(at, course));
    }

    /** The state of the drone at a place, m, on a course given by its number. */
    FlightState state(Position at, int course) {
        return courses.get(course).at(at, drone.settings().speed());
    }

    /** The numbers of those courses that would also be there if this were the only sensor; of all if there are none. */
    int[] ownCourses() {
        int[] own = IntStream.range(0, courses.size())
                .filter(course -> courses.get(course)
                        .sensor()
                        .filter(id -> !id.equals(sensor))
                        .isEmpty())
                .toArray();
        return own.length == 0 ? IntStream.range(0, courses.size()).toArray() : own;
    }

    /**
     * The first course on which the sensor certainly looks at the same picture as on a given one: if speed does not
     * matter to it, hovering is the same as flying on that heading.
     */
    int alike(int course) {
        return assessor.isSameAtAllSpeeds() ? Course.firstOnSameHeading(courses, course) : course;
    }

    /** Where the sensor's positioner points once it has turned to a place, m; empty on a fixed mount. */
    Optional<Pointing> pointing(Position at) {
        return Mounted.turnedTo(settings, at);
    }

    /** Where the sensor points while the drone is at a position, m. */
    public CellPointings pointings(Position at) {
        return search.map(its -> its.at(at, drone.radius())).orElseGet(() -> CellPointings.always(pointing(at)));
    }

    /**
     * The assessment of a drone, exact only to the steps of a {@link CellCode}, and therefore faster;
     * interpolated, if this sensor's signals are.
     */
    Assessment assessInSteps(Assessor assessor, Drone there, Optional<Pointing> pointing) {
        if (isExactAlone()) {
            Signal heard = assessor.interpolable().orElseThrow().signalOnExactPaths(world, there);
            return assessor.assess(heard, there, pointing);
        }
        return excess().isPresent()
                ? new InterpolatedCells(this, excess().get(), assessor).assess(there, pointing)
                : assessCoarsely(assessor, there, pointing);
    }

    /** The assessment of a drone, exact only to the steps of a {@link CellCode}, without interpolation. */
    Assessment assessCoarsely(Assessor assessor, Drone there, Optional<Pointing> pointing) {
        return assessor.assessCoarsely(there, pointing, rays(), resolution(assessor, there, pointing));
    }

    /**
     * Whether the needed step is reached suffices only if the answer is the same on all courses; otherwise, which
     * course counts depends on more than that.
     */
    private ProbabilityResolution resolution(Assessor assessor, Drone there, Optional<Pointing> pointing) {
        boolean isSideOnly = needed().isPresent()
                && search.isEmpty()
                && (courses.size() == 1 || assessor.isSameAtAllHeadings(there, pointing));
        return isSideOnly ? terms.sideOf(needed().getAsInt(), settings) : terms.resolution(settings);
    }

    /**
     * The probability that the sensor detects the drone on the terms of the field, in the steps of a
     * {@link CellCode}.
     *
     * @param ofALook the probability of a look, 0 to 1
     */
    int steps(double ofALook) {
        return ProbabilityStep.of(
                excess().isPresent()
                        ? ofALook * terms.probability(1.0, settings)
                        : terms.probability(ofALook, settings));
    }

    /**
     * The probability on the terms of the field. Where signals are interpolated, a probability represents what is not
     * known, and is the same for any number of looks.
     */
    private double onTerms(double[] looks, CellPointings pointings, double mean) {
        if (excess().isPresent()) {
            return mean * terms.probability(1.0, settings);
        }
        return search.flatMap(SearchPeriod::window)
                .map(window -> window.probability(looks, pointings.phases()))
                .orElseGet(() -> terms.probability(mean, settings));
    }

    /** A look that is only as fine as the steps of a {@link CellCode}, and faster. */
    CellLook lookInSteps(Assessor assessor, Drone there, CellPointings pointings) {
        return look(pointings, pointing -> assessInSteps(assessor, there, pointing));
    }

    /** The result of the looks at a drone, not rounded to steps. */
    public CellLook look(Assessor assessor, Drone there, CellPointings pointings) {
        return look(pointings, pointing -> assess(assessor, there, pointing));
    }

    /** The assessment as it is. */
    Assessment assess(Assessor assessor, Drone there, Optional<Pointing> pointing) {
        return assessor.assess(there, pointing, rays());
    }

    /**
     * The mean over all pointings. Its cause is that of the most favourable one or, for a drone that would be detected
     * with that one but is out of view most of the time, {@link Cause#OUT_OF_VIEW}.
     */
    private CellLook look(CellPointings pointings, Function<Optional<Pointing>, Assessment> glance) {
        LookSeries series = new LookSeries(
                pointings.passes(),
                pointings.towards().size(),
                number -> glance.apply(pointings.towards().get(number)));
        double[] probabilities = series.probabilities();
        Optional<Assessment> best = series.best();
        double mean =
                pointings.share() * DoubleStream.of(probabilities).average().orElse(0.0);
        boolean isMissed = best.isEmpty() || best.get().cause() == Cause.DETECTED && mean < EVEN_CHANCE;
        Assessment shown =
                isMissed && pointings.away().isPresent() ? glance.apply(pointings.away()) : best.orElseThrow();
        return new CellLook(onTerms(probabilities, pointings, mean), shown);
    }

    /**
     * The random rays of the first look of a run: they are the same for all cells, so that the field varies only with
     * the position.
     */
    private RandomGenerator rays() {
        return Draws.stream(seed, sensor, drone.id(), 0, RaySensor.RAYS);
    }
}
