package org.dronewatch.analysis;

import java.util.List;
import java.util.Optional;
import java.util.function.IntConsumer;
import java.util.random.RandomGenerator;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.AssessableSensor;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.AssessmentBounds;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.BoundingSensor;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.Explanation;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.ProbabilityResolution;
import org.dronewatch.sensor.RaySensor;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.world.World;

/** One sensor that looks at all points. */
final class Prober {
    private static final double EVEN_CHANCE = 0.5;

    private final CoverageGrid grid;
    private final SurfaceHeights heights;
    private final World world;
    private final Drone drone;
    private final SensorSettings<?> settings;
    private final String id;
    private final long seed;
    private final Assessor assessor;
    private final Position from;

    /** What turns the sensor; empty for a fixed mount. */
    private final Optional<Mounted> mount;

    Prober(
            CoverageGrid grid,
            SurfaceHeights heights,
            World world,
            Drone drone,
            SensorSettings<?> settings,
            String id,
            long seed) {
        this.grid = grid;
        this.heights = heights;
        this.world = world;
        this.drone = drone;
        this.settings = settings;
        this.id = id;
        this.seed = seed;
        this.assessor = new Assessor(id, settings, world);
        this.from = settings.position();
        this.mount = settings.as(Mounted.class).filter(one -> one.positioner().isPresent());
    }

    /** What the sensor answers in each cell. */
    enum Answer {
        /** It does not detect the drone, or there is no drone because there is no ground. */
        MISSED,
        DETECTED,
        /** The line of sight leaves the known ground. */
        UNKNOWN
    }

    /** What is found in each cell. */
    record Findings(Answer[] answers, Cause[] causes) {
        /** Nothing yet. */
        Findings(int cells) {
            this(new Answer[cells], new Cause[cells]);
        }
    }

    /** What one thread looks with. */
    private record Eye(Sensor sensor, Assessor assessor) {}

    /** Looks at all cells on the {@link Workers} of the calling thread; leaves out causes that cost more. */
    Findings probe(IntConsumer progress) {
        Findings found = new Findings(grid.cells() * grid.cells());
        // Two loops: the compiler translates each for its kind of sensor, and keeps what it has translated.
        boolean hasBounds = assessor.isBounding();
        Workers.forEach(grid.cells(), () -> new Eye(settings.create(), assessor.sibling()), (eye, row) -> {
            if (hasBounds) {
                bound(eye, row, found);
            } else {
                look(eye, row, found);
            }
            progress.accept(grid.cells());
        });
        return found;
    }

    /** Looks only where bounds leave the answer open. */
    private void bound(Eye eye, int row, Findings found) {
        for (int column = 0; column < grid.cells(); column++) {
            int cell = row * grid.cells() + column;
            Position at = position(column, row);
            if (isOpen(cell, at, found)) {
                bound(eye, cell, at, found);
            }
        }
    }

    private void bound(Eye eye, int cell, Position at, Findings found) {
        Optional<Pointing> pointing = turnedTo(at);
        Optional<AssessmentBounds> bounds = eye.assessor.boundAtAllHeadings(drone, at, pointing);
        if (bounds.isEmpty() || !isDecisive(bounds.get())) {
            FlightState state = comingFrom(at);
            bounds = eye.assessor.bound(drone, state, pointing, Prober::step);
            if (bounds.isEmpty() || !isDecisive(bounds.get())) {
                look(eye, cell, drone.at(state), found);
                return;
            }
        }
        found.answers[cell] = bounds.get().least() >= EVEN_CHANCE ? Answer.DETECTED : Answer.MISSED;
        found.causes[cell] = bounds.get().cause();
    }

    private void look(Eye eye, int row, Findings found) {
        for (int column = 0; column < grid.cells(); column++) {
            int cell = row * grid.cells() + column;
            Position at = position(column, row);
            if (isOpen(cell, at, found)) {
                look(eye, cell, drone.at(comingFrom(at)), found);
            }
        }
    }

    private void look(Eye eye, int cell, Drone drawn, Findings found) {
        found.answers[cell] = isDetected(eye, look(cell, drawn), drawn) ? Answer.DETECTED : Answer.MISSED;
    }

    /**
     * Whether a cell has ground, and all ground below the line of sight to it is known; if not, {@code found} then
     * holds the answer for the cell.
     *
     * @param at its position; null without ground
     */
    private boolean isOpen(int cell, Position at, Findings found) {
        found.answers[cell] = at == null || world.isKnown(from, at) ? Answer.MISSED : Answer.UNKNOWN;
        return at != null && found.answers[cell] == Answer.MISSED;
    }

    private static boolean isDecisive(AssessmentBounds bounds) {
        return step(bounds.least()) == step(bounds.greatest());
    }

    private static int step(double probability) {
        return probability >= EVEN_CHANCE ? 1 : 0;
    }

    /**
     * Whether the drone is detected, by its probability: a draw for each cell would show speckle. Rays are traced once,
     * as in a run.
     */
    private boolean isDetected(Eye eye, Look look, Drone there) {
        Sensor sensor = eye.sensor;
        RandomGenerator random = look.random(there.id(), RaySensor.RAYS);
        if (sensor instanceof BoundingSensor) {
            // The assessor has already traced the site for its bounds.
            return eye.assessor
                            .assessCoarsely(there, look.pointing(), random, ProbabilityResolution.sideOf(EVEN_CHANCE))
                            .probability()
                    >= EVEN_CHANCE;
        }
        if (sensor instanceof AssessableSensor assessable && !(sensor instanceof RaySensor)) {
            return assessable.signal(world, there, look.pointing(), random).probability() >= EVEN_CHANCE;
        }
        if (sensor instanceof RaySensor rays && settings.chance() == Chance.PER_LOOK) {
            return rays.detects(world, there, look);
        }
        return sensor.observe(world, List.of(there), look).stream()
                .filter(seen -> seen.drone().equals(drone.id()))
                .anyMatch(this::isDetected);
    }

    /**
     * Judged by the probability, if it is stated or chance decides once per encounter: in a single look, an observer
     * has had no time to search.
     */
    private boolean isDetected(Observation seen) {
        return settings.chance() == Chance.PER_ENCOUNTER || seen.statesProbability()
                ? seen.probability() >= EVEN_CHANCE
                : seen.isDetected();
    }

    Optional<Assessment> assess(int column, int row) {
        return comingFrom(column, row).map(drone::at).map(there -> {
            Look look = look(row * grid.cells() + column, there);
            return assessor.assess(there, look.pointing(), look.random(there.id(), RaySensor.RAYS));
        });
    }

    Optional<Explanation> explain(int column, int row) {
        return comingFrom(column, row)
                .map(drone::at)
                .map(there -> assessor.explainMiss(there, turnedTo(there.origin())));
    }

    private Look look(int cell, Drone there) {
        return Look.of(seed, id, cell, 0.0).withPointing(turnedTo(there.origin()));
    }

    private Optional<Pointing> turnedTo(Position at) {
        return mount.isEmpty() ? Optional.empty() : mount.get().turnedTo(at);
    }

    /** The state of the drone in a cell; empty where there is no ground. */
    private Optional<FlightState> comingFrom(int column, int row) {
        return Optional.ofNullable(position(column, row)).map(this::comingFrom);
    }

    /** Where the drone is in a cell; null where there is no ground. */
    private Position position(int column, int row) {
        double ground = heights.height[row * grid.cells() + column];
        return Double.isNaN(ground) ? null : new Position(grid.x(column), grid.y(row), ground + grid.height());
    }

    private FlightState comingFrom(Position position) {
        Position vector = from.minus(position);
        double length = Math.max(vector.length(), Double.MIN_NORMAL);
        Position velocity = vector.times(drone.settings().speed() / length);
        return new FlightState(position, velocity, Math.atan2(vector.x(), vector.y()));
    }
}
