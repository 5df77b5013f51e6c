package org.dronewatch.route;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.dronewatch.LongForm;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.exposure.LegMotion;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.Draws;
import org.dronewatch.sensor.RaySensor;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Among four boxes, the levels of a microphone are interpolated, so that it is not certain in which cells it detects a
 * drone: of many short flights through these, as many are detected as the exposures of the nearest cells say. Between
 * the middles of cells, of which one is certain to detect the drone, exposures are too high, never too low. Only in the
 * long form.
 */
class InterpolatedExposureTest {
    private static final FieldGrid GRID = new FieldGrid(0.7, 0.3, 400, 4, List.of(3.0, 10.0, 20.0, 60.0));
    private static final int FLIGHTS = 250;
    private static final double SPEED = 12.0;

    @TempDir
    private Path directory;

    @ParameterizedTest(name = "{0} Hz")
    @ValueSource(doubles = {2.0, 10.0})
    void asManyFlightsAreDetectedAsTheirExposuresSay(double rate) throws IOException {
        assumeThat(LongForm.IS_ON).isTrue();
        FieldSite site = FieldSite.in(
                directory,
                "  ear: {kind: acoustic, position: [0, 0, 4], rate: " + rate
                        + ", propagation: {kind: energy-model, rays: 100}}\n");
        DetectionField field = site.field(GRID, 2);
        DroneSettings settings = site.settings().drones().get(FieldSite.DRONE);
        FieldExposure exposure = FieldExposure.of(ModeField.powered(field, settings), site.settings());
        Assessor ear = new Assessor(
                "ear", site.settings().enabledSensors().get("ear"), site.stage().world());
        Drone drone = DetectionField.droneOf(site.stage(), FieldSite.DRONE);
        long seed = LongForm.seed(0);
        SplittableRandom random = new SplittableRandom(seed);
        double predicted = 0.0;
        double variance = 0.0;
        double between = 0.0;
        int detected = 0;
        for (int flights = 0; flights < FLIGHTS; ) {
            Position from = anywhere(random);
            double heading = 2.0 * Math.PI * random.nextDouble();
            Position velocity = new Position(SPEED * Math.sin(heading), SPEED * Math.cos(heading), 0.0);
            int looks = (int) (rate * (2.5 + 7.5 * random.nextDouble()));
            Position step = velocity.times(1.0 / rate);
            double sum = exposure(exposure, field, from, velocity, step, looks) / rate;
            double chance = -Math.expm1(-sum);
            // A look from a cell that is certain to detect the drone adds 13.8.
            if (sum > 0.0 && sum < 6.0 && isInside(from.plus(step.times(looks)))) {
                flights++;
                predicted += chance;
                variance += chance * (1.0 - chance);
                between += -Math.expm1(-interpolated(exposure, from, velocity, step, looks) / rate);
                detected += isDetected(ear, drone, from, velocity, step, looks) ? 1 : 0;
            }
        }
        assertThat(site.settings().enabledSensors().get("ear").rate()).isEqualTo(rate);
        assertThat(field.interpolated()).containsKey("ear");
        System.out.printf(
                "InterpolatedExposureTest: %.0f Hz, seed %d, %.1f predicted, %.1f between cells, %d detected, limit %.1f%n",
                rate, seed, predicted, between, detected, 4.0 * Math.sqrt(variance));
        assertThat(Math.abs(detected - predicted)).isLessThan(4.0 * Math.sqrt(variance));
        assertThat(between).isGreaterThan(detected - 4.0 * Math.sqrt(variance));
    }

    private static Position anywhere(SplittableRandom random) {
        return new Position(
                400 * (random.nextDouble() - 0.5), 400 * (random.nextDouble() - 0.5), 3 + 20 * random.nextDouble());
    }

    private static boolean isInside(Position at) {
        return Math.max(Math.abs(at.x()), Math.abs(at.y())) < 199.0;
    }

    /** The sum of the rates in the middles of the cells that are nearest to the looks, 1/s. */
    private static double exposure(
            FieldExposure exposure, DetectionField field, Position from, Position velocity, Position step, int looks) {
        LegMotion motion = LegMotion.along(velocity.x(), velocity.y(), 0.0, 1.0);
        double sum = 0.0;
        for (int look = 0; look < looks; look++) {
            Position at = from.plus(step.times(look));
            int column = nearest((at.x() - GRID.x(0)) / GRID.cell());
            int row = nearest((GRID.y(0) - at.y()) / GRID.cell());
            int height = IntStream.range(0, GRID.heights().size())
                    .boxed()
                    .min(Comparator.comparingDouble(i -> Math.abs(GRID.heights().get(i) - at.z())))
                    .orElseThrow();
            Position middle = field.middle(height, column, row);
            sum += exposure.rate(middle.x(), middle.y(), middle.z(), motion, 0);
        }
        return sum;
    }

    private static int nearest(double index) {
        return (int) Math.max(0, Math.min(GRID.columns() - 1, Math.rint(index)));
    }

    /** The sum of the rates at the looks, 1/s. */
    private static double interpolated(
            FieldExposure field, Position from, Position velocity, Position step, int looks) {
        LegMotion motion = LegMotion.along(velocity.x(), velocity.y(), 0.0, 1.0);
        double sum = 0.0;
        for (int look = 0; look < looks; look++) {
            Position at = from.plus(step.times(look));
            sum += field.rate(at.x(), at.y(), at.z(), motion, 0);
        }
        return sum;
    }

    private static boolean isDetected(
            Assessor ear, Drone drone, Position from, Position velocity, Position step, int looks) {
        double heading = Math.atan2(velocity.x(), velocity.y());
        for (int look = 0; look < looks; look++) {
            Position at = from.plus(step.times(look));
            if (ear.assess(
                                    drone.at(new FlightState(at, velocity, heading)),
                                    Optional.empty(),
                                    Draws.stream(7, "ear", FieldSite.DRONE, 0, RaySensor.RAYS))
                            .probability()
                    > 0.0) {
                return true;
            }
        }
        return false;
    }
}
