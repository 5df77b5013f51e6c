package org.dronewatch.route;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.SplittableRandom;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldAssessment;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.exposure.LegMotion;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.SensorSettings;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * A radar with a notch, at any heading: the error of its probabilities, on average, is less than half of what it would
 * be if each heading counted as the nearest of those of the field.
 */
class NotchRatesTest {
    private static final FieldGrid GRID = new FieldGrid(0, 0, 400, 20, List.of(30.0, 60.0));

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "{kind: high-pass, halfPowerSpeed: 4 m/s}               | POWERED | 12   | 140",
                "{kind: canceller, pulses: 3, blindSpeed: 15 m/s}       | POWERED | 12   | 140",
                "{kind: high-pass, halfPowerSpeed: 4 m/s}               | SLOW    | 1.26 | 400"
            })
    void probabilitiesLieBetweenThoseOfTheHeadings(
            String notch, FlightMode.Kind kind, double speed, double range, @TempDir Path directory)
            throws IOException {
        FieldSite site = FieldSite.in(
                directory,
                "  notched: {kind: radar, position: [0, 0, 4], minRange: 1, maxRange: 400, elevationWidth: 90 deg,"
                        + " budget: {range: " + range + ", crossSection: 0.01}, notch: " + notch
                        + ", detection: {kind: chance, pulses: 8}}\n");
        Drone drone = DetectionField.droneOf(site.stage(), FieldSite.DRONE);
        FlightMode mode = new FlightMode(kind, speed);
        DetectionField field = FieldAssessment.of(
                site.settings(),
                site.stage(),
                FieldSite.DRONE,
                GRID,
                mode.courses(site.settings().enabledSensors(), drone),
                cells -> {});
        FieldExposure exposure = FieldExposure.of(mode.with(field, drone.settings()), site.settings());
        SensorSettings<?> radar = site.settings().enabledSensors().get("notched");
        Assessor assessor = new Assessor("notched", radar, site.stage().world());
        SplittableRandom random = new SplittableRandom(9);
        double between = 0.0;
        double nearest = 0.0;
        int count = 4000;
        for (int i = 0; i < count; i++) {
            int level = random.nextInt(2);
            int column = random.nextInt(20);
            int row = random.nextInt(20);
            Position at = field.middle(level, column, row);
            double heading = 2.0 * Math.PI * random.nextDouble();
            LegMotion motion = LegMotion.along(speed * Math.sin(heading), speed * Math.cos(heading), 0.0, 1.0);
            Position velocity = new Position(motion.east(), motion.north(), 0.0);
            double exact = assessor.assess(
                            drone.at(new FlightState(at, velocity, heading)), Optional.empty(), new Random(0))
                    .probability();
            double rate = exposure.rate(at.x(), at.y(), at.z(), motion, 0);
            between += Math.abs(-Math.expm1(-rate / radar.rate()) - exact) / count;
            int course = Math.floorMod((int) Math.rint(heading / (2.0 * Math.PI) * 8), 8);
            nearest += Math.abs(field.probability(0, level, column, row, course) - exact) / count;
        }
        System.out.printf("NotchRatesTest: %.4f instead of %.4f%n", between, nearest);
        assertThat(between).isLessThan(0.03);
        assertThat(between).isLessThan(0.5 * nearest);
    }
}
