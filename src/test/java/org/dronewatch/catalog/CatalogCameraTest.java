package org.dronewatch.catalog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronewatch.catalog.CatalogEntry.PublishedRange;
import org.dronewatch.flight.FlightPathSettings.Approach;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Aimed;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.SensorSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Cameras of the catalogue have an even chance of detecting the drone at the published range.
 *
 * <p>How many pixels the drone covers depends on where it falls on their grid, and with them the probability varies
 * from frame to frame: the mean over many places on the grid is what is calibrated.
 */
class CatalogCameraTest {
    /** The kinds that measure a probability. */
    static final Set<String> KINDS = Set.of("camera", "thermal");

    private static final Position SENSOR = new Position(0, 0, 10);
    private static final int SIDE = 5;
    private static final double NEARLY = 0.05;

    /**
     * By how much the probability changes around 0.5 with 5 % of the range: {@code dP / dln r = E P (1 - P)} with the
     * exponent {@code E = 2.7 + 0.7} of the target transfer probability function, 0.85.
     */
    private static final double SLACK = 0.85 * NEARLY;

    @TempDir
    private Path directory;

    /** One sensor, and drones that come at it side by side, from a little more than a range to a little less. */
    private static final class Formation extends Scene {
        private static final long serialVersionUID = 1L;

        private final transient SensorSettings<?> sensor;
        private final transient PublishedRange range;
        private final double distance;

        Formation(SensorSettings<?> sensor, PublishedRange range, double distance) {
            this.sensor = sensor;
            this.range = range;
            this.distance = distance;
        }

        @Override
        protected void build() {
            loadWorld(range.worldOf(ModelSettings.of("grass.obj")).models().get(0));
            Position middle = SENSOR.plus(new Position(0, distance, 0));
            add("sensor", sensor.as(Aimed.class).orElseThrow().withAim(new Aim.Target(middle)));
            double speed = 0.002 * distance * sensor.rate();
            for (int i = 0; i < SIDE * SIDE; i++) {
                // Each crosses half a pixel or more in both directions as it comes nearer, so that all places on the
                // grid occur. None hides another, and all are seen head-on, at most 1 deg from the axis.
                double right = 0.0071 * distance * (i % SIDE - 1.7);
                double up = 0.0013 * distance * (i / SIDE + 1);
                Position aside = SENSOR.plus(new Position(right, 0, up));
                Position far = aside.plus(new Position(0, (1.0 + NEARLY) * distance, 0));
                Position near = aside.plus(new Position(0, (1.0 - NEARLY) * distance, 0));
                add("drone" + i, range.droneOn(new Approach(far, near)).withSpeed(speed));
            }
            setRun(RunSettings.DEFAULT.withDuration(2.0 * NEARLY * distance / speed - 1e-6));
        }
    }

    private static List<Object[]> promises() {
        List<Object[]> all = new ArrayList<>();
        for (String name : Catalog.packagedNames()) {
            CatalogEntry entry = Catalog.packaged().entry(name).orElseThrow();
            if (KINDS.contains(entry.kind())) {
                entry.ranges().forEach(range -> all.add(new Object[] {name, range}));
            }
        }
        return all;
    }

    @Test
    void twoCamerasHaveTwoRangesEach() {
        assertThat(promises()).hasSize(4);
    }

    @ParameterizedTest
    @MethodSource("promises")
    void atThePublishedRangeTheChanceIsEven(String name, PublishedRange range) throws IOException {
        Files.writeString(directory.resolve("grass.mtl"), "newmtl grass\n");
        Files.writeString(
                directory.resolve("grass.obj"),
                "mtllib grass.mtl\nusemtl grass\nv -5000 0 -5000\nv 5000 0 -5000\nv 5000 0 5000\nv -5000 0 5000\n"
                        + "f 1 3 2\nf 1 4 3\n");
        SensorSettings<?> sensor = Catalog.packaged().settings(name, Map.of("position", SENSOR));

        assertThat(mean(sensor, range, range.distance())).isCloseTo(0.5, within(SLACK));
    }

    private double mean(SensorSettings<?> sensor, PublishedRange range, double distance) {
        List<Observation> seen = new ArrayList<>();
        new SceneRunner(new Formation(sensor, range, distance))
                .directory(directory)
                .onFrame(frame -> seen.addAll(frame.observations()))
                .run();
        assertThat(seen).hasSizeGreaterThanOrEqualTo(SIDE * SIDE * 45);
        return seen.stream()
                .mapToDouble(one -> one.figures().get(Observation.PROBABILITY))
                .average()
                .orElseThrow();
    }
}
