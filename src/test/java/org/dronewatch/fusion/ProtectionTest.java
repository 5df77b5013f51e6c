package org.dronewatch.fusion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.AlertResult;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.InputException;
import org.dronewatch.world.GroundPoint;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Polygon;

/**
 * Protected areas: their distances by another library, where flights enter them by small steps, and scenes with
 * several.
 */
class ProtectionTest {
    private static final String SCENE =
            """
            world: {models: [{file: slope.obj, upAxis: z, role: terrain}]}
            drones:
              guest: {model: packaged:quadrotor.obj, speed: 10 m/s, flight: {kind: approach, from: [0, 300, 55], to: [0, -300, 55]}}
            sensors:
              box: {kind: rf, position: [0, 0, 90]}
            alert: {response: 5 s, %s}
            run: {duration: 60 s}
            """;

    @TempDir
    private Path directory;

    private static List<GroundPoint> corners(double... xy) {
        List<GroundPoint> corners = new ArrayList<>();
        for (int i = 0; i < xy.length; i += 2) {
            corners.add(new GroundPoint(xy[i], xy[i + 1]));
        }
        return corners;
    }

    /** An L, from 10 to 30 m. */
    private static AreaZone angle() {
        List<GroundPoint> corners = corners(0, 0, 40, 0, 40, 10, 10, 10, 10, 50, 0, 50);
        return new AreaZone("angle", ProtectedArea.polygon(corners, 30), 10, 30);
    }

    private static AreaZone disc() {
        return new AreaZone("disc", ProtectedArea.circle(new GroundPoint(20, 20), 15, 30), 10, 30);
    }

    private static Position anywhere(Random random) {
        return new Position(100 * random.nextDouble() - 30, 100 * random.nextDouble() - 30, 60 * random.nextDouble());
    }

    @Test
    void distancesAreThoseToTheSurface() {
        GeometryFactory geometry = new GeometryFactory();
        Coordinate[] ring = angle().outline().stream()
                .map(corner -> new Coordinate(corner.x(), corner.y()))
                .toArray(Coordinate[]::new);
        Coordinate[] closed = Arrays.copyOf(ring, ring.length + 1);
        closed[ring.length] = ring[0];
        Polygon polygon = geometry.createPolygon(closed);
        Random random = new Random(5);
        for (int i = 0; i < 5000; i++) {
            Position at = anywhere(random);
            double beside = polygon.distance(geometry.createPoint(new Coordinate(at.x(), at.y())));
            double above = Math.max(0, Math.max(10 - at.z(), at.z() - 30));
            assertThat(angle().distance(at)).isCloseTo(Math.hypot(beside, above), within(1e-9));
            double off = Math.max(0, Math.hypot(at.x() - 20, at.y() - 20) - 15);
            assertThat(disc().distance(at)).isCloseTo(Math.hypot(off, above), within(1e-9));
        }
    }

    /** 2000 steps are less than 0.1 m each; a flight that only grazes a corner for less than that is not looked at. */
    @Test
    void flightsEnterWhereSmallStepsDo() {
        Random random = new Random(6);
        int entering = 0;
        for (int i = 0; i < 2000; i++) {
            Position from = anywhere(random);
            Position to = anywhere(random);
            AreaZone zone = i % 2 == 0 ? angle() : disc();
            OptionalDouble share = zone.entry(from, to);
            double inside = Double.POSITIVE_INFINITY;
            for (int step = 0; step <= 2000 && Double.isInfinite(inside); step++) {
                Position at = from.plus(to.minus(from).times(step / 2000.0));
                inside = zone.distance(at) == 0.0 ? step / 2000.0 : inside;
            }
            if (Double.isFinite(inside)) {
                entering++;
                assertThat(share.orElseThrow()).isBetween(inside - 1 / 2000.0 - 1e-9, inside + 1e-9);
            } else if (share.isPresent()) {
                Position at = from.plus(to.minus(from).times(share.getAsDouble()));
                assertThat(zone.distance(at)).isLessThan(1e-9);
            }
        }
        assertThat(entering).isBetween(200, 1800);
    }

    @Test
    void aStraightFlightThroughAFaceEntersAtItsPlane() {
        assertThat(angle().entry(new Position(20, -30, 20), new Position(20, 70, 20)))
                .hasValue(0.3);
        // From above, through the top.
        assertThat(angle().entry(new Position(5, 5, 50), new Position(5, 5, 0))).hasValue(0.4);
        // In the inner corner of the angle, and above everything.
        assertThat(angle().entry(new Position(20, 20, 20), new Position(50, 50, 20)))
                .isEmpty();
        assertThat(angle().entry(new Position(20, -30, 31), new Position(20, 70, 31)))
                .isEmpty();
        assertThat(disc().entry(new Position(20, -30, 20), new Position(20, 70, 20))
                        .orElseThrow())
                .isCloseTo(0.35, within(1e-12));
    }

    private AlertResult run(String alert) throws IOException {
        Files.writeString(
                directory.resolve("slope.obj"),
                "v -400 -400 0\nv 400 -400 80\nv 400 400 80\nv -400 400 0\nf 1 2 3 4\n");
        Path file = Files.writeString(directory.resolve("scene.yaml"), String.format(SCENE, alert));
        return new SceneRunner(new SceneFile(file)).threads(1).run().alert("guest");
    }

    /** The ground is at 40 m + x / 10: under the field between 38 and 42 m. */
    @Test
    void theFirstZoneCountsOnItsGround() throws IOException {
        String field = "field: {area: [[-20, -100], [20, -100], [20, 100], [-20, 100]], floor: 1 m, height: 14 m}";
        AlertResult both = run("zones: {" + field + ", far: {centre: [0, -200], radius: 50, height: 100}}");
        assertThat(both.zone()).contains("field");
        assertThat(both.entered().orElseThrow()).isCloseTo(20.0, within(1e-9));
        // The top of the lower one, 42 + 12.9 m, is just below the flight.
        AlertResult low = run(
                "zones: {" + field.replace("14 m", "12.9 m") + ", far: {centre: [0, -200], radius: 50, height: 100}}");
        assertThat(low.zone()).contains("far");
        assertThat(low.entered().orElseThrow()).isCloseTo(45.0, within(1e-9));
        // A floor above it: 38 + 18 m is the lowest point of one that hangs in the air.
        assertThat(run("zones: {" + field.replace("floor: 1 m, height: 14 m", "floor: 18 m, height: 40 m") + "}")
                        .entered())
                .isEmpty();
        // Beside a sphere, which has no name.
        AlertResult sphere = run("protect: {centre: [0, 200, 55], radius: 30}, zones: {" + field + "}");
        assertThat(sphere.zone()).contains(Protection.ZONE);
        assertThat(sphere.entered().orElseThrow()).isCloseTo(7.0, within(1e-9));
        assertThat(run("protect: {centre: [0, 200, 55], radius: 30}").zone()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "a: {area: [[0, 0], [9, 0]], height: 5} | area has 2 corners but must have 3 to 1000",
                "a: {area: [[0, 0], [9, 9], [9, 0], [0, 9]], height: 5} | area crosses itself: its side from corner 1 to 2"
                        + " meets that from corner 3 to 4",
                "a: {area: [[0, 0], [9, 0], [18, 0]], height: 5} | area encloses 0.0 m2 but must enclose at least 0.01 m2",
                "a: {area: [[0, 0], [9, 0], [9, 9]]} | needs 'height'",
                "a: {area: [[0, 0], [9, 0], [9, 9]], height: 0} | must be above 0",
                "a: {area: [[0, 0], [9, 0], [9, 9]], floor: 6, height: 5} | floor 6.0 m must be below the height",
                "a: {height: 5} | needs an outline",
                "a: {centre: [0, 0], height: 5} | needs an outline",
                "a: {area: [[0, 0], [9, 0], [9, 9]], radius: 3, height: 5} | has both an area and a circle",
                "a: {centre: [9000, 0], radius: 3, height: 5} | alert.zones.a: there is no ground below it",
            })
    void mistakesAreNamedInALine(String zones, String message) {
        assertThatThrownBy(() -> run("zones: {" + zones + "}"))
                .isInstanceOf(InputException.class)
                .satisfies(e -> {
                    assertThat(e.getMessage().lines()).hasSize(1);
                    assertThat(e.getMessage()).contains("zones").contains("a").contains(message);
                });
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 1001})
    void fewOrManyCornersAreNoArea(int count) {
        List<GroundPoint> corners = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            corners.add(new GroundPoint(Math.cos(i), Math.sin(i)));
        }
        if (count == 0) {
            assertThatThrownBy(() -> AlertSettings.DEFAULT.withZone("a", ProtectedArea.polygon(corners, 5)))
                    .hasMessageContaining("needs an outline");
        } else {
            assertThatThrownBy(() -> ProtectedArea.polygon(corners, 5)).hasMessageContaining("must have 3 to 1000");
        }
    }

    @Test
    void withoutAnythingProtectedNothingIsNear() {
        Protection none = new Protection(Optional.empty(), List.of());
        assertThat(none.isEmpty()).isTrue();
        assertThat(none.nearest(new Position(0, 0, 0))).isEmpty();
        assertThat(none.distance(new Position(0, 0, 0))).isInfinite();
    }
}
