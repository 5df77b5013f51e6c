package org.dronewatch.analysis;

import java.util.List;
import java.util.Optional;
import java.util.function.IntConsumer;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.AssessableSensor;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.Explanation;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.RaySensor;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.world.World;

/** One sensor that looks at all points, one after the other. */
record Prober(
        CoverageGrid grid,
        SurfaceHeights heights,
        World world,
        Drone drone,
        SensorSettings<?> settings,
        String id,
        long seed,
        Assessor assessor) {

    private static final double EVEN_CHANCE = 0.5;

    /** What the sensor answers in each cell. */
    enum Answer {
        /** It does not detect the drone, or there is no drone because there is no ground. */
        MISSED,
        DETECTED,
        /** The line of sight leaves the known ground. */
        UNKNOWN
    }

    Answer[] probe(IntConsumer progress) {
        Sensor sensor = settings.create();
        Answer[] cells = new Answer[grid.cells() * grid.cells()];
        for (int row = 0; row < grid.cells(); row++) {
            Workers.checkInterrupted();
            for (int column = 0; column < grid.cells(); column++) {
                int cell = row * grid.cells() + column;
                Optional<Drone> there = comingFrom(column, row);
                cells[cell] = there.map(one -> answer(sensor, cell, one)).orElse(Answer.MISSED);
            }
            progress.accept(grid.cells());
        }
        return cells;
    }

    private Answer answer(Sensor sensor, int cell, Drone there) {
        if (!world.isKnown(settings.position(), there.origin())) {
            return Answer.UNKNOWN;
        }
        return isDetected(sensor, look(cell, there), there) ? Answer.DETECTED : Answer.MISSED;
    }

    /** By its probability: a draw for each cell would show speckle. Rays are traced once, as in a run. */
    private boolean isDetected(Sensor sensor, Look look, Drone there) {
        if (sensor instanceof AssessableSensor assessable && !(sensor instanceof RaySensor)) {
            return assessable
                            .signal(world, there, look.pointing(), look.random(there.id(), RaySensor.RAYS))
                            .probability()
                    >= EVEN_CHANCE;
        }
        return sensor.observe(world, List.of(there), look).stream()
                .filter(seen -> seen.drone().equals(drone.id()))
                .anyMatch(this::isDetected);
    }

    /** An observer has had no time to search in a single look. */
    private boolean isDetected(Observation seen) {
        return settings.chance() == Chance.PER_ENCOUNTER ? seen.probability() >= EVEN_CHANCE : seen.isDetected();
    }

    Optional<Assessment> assess(int column, int row) {
        return comingFrom(column, row).map(there -> {
            Look look = look(row * grid.cells() + column, there);
            return assessor.assess(there, look.pointing(), look.random(there.id(), RaySensor.RAYS));
        });
    }

    Optional<Explanation> explain(int column, int row) {
        return comingFrom(column, row).map(there -> assessor.explainMiss(there, turnedTo(there)));
    }

    private Look look(int cell, Drone there) {
        return Look.of(seed, id, cell, 0.0).withPointing(turnedTo(there));
    }

    private Optional<Pointing> turnedTo(Drone there) {
        return Mounted.turnedTo(settings, there.origin());
    }

    /** The drone in a cell; empty where there is no ground. */
    private Optional<Drone> comingFrom(int column, int row) {
        double ground = heights.height[row * grid.cells() + column];
        if (Double.isNaN(ground)) {
            return Optional.empty();
        }
        Position position = new Position(grid.x(column), grid.y(row), ground + grid.height());
        Position vector = settings.position().minus(position);
        double length = Math.max(vector.length(), Double.MIN_NORMAL);
        Position velocity = vector.times(drone.settings().speed() / length);
        return Optional.of(drone.at(new FlightState(position, velocity, Math.atan2(vector.x(), vector.y()))));
    }
}
