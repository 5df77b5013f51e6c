package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.sensor.Observation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The size of a sensor: a model of its housing stands in the world, and hides from others what is behind it. */
class SensorHousingTest {
    /**
     * A plate of 0.7 m x 0.5 m that faces south, 1 m north of the origin and centred 20 m above it; y is up in the
     * file.
     */
    private static final String HOUSING =
            "v -0.35 19.75 -1\nv 0.35 19.75 -1\nv 0.35 20.25 -1\nv -0.35 20.25 -1\nf 1 2 3 4\n";

    @TempDir
    private Path directory;

    /** Pixels of drones that hover 20 m north of the camera, each 5 m farther to the east. */
    private List<Double> pixels(String models) throws IOException {
        StringBuilder drones = new StringBuilder();
        for (int i = 0; i < 3; i++) {
            drones.append("  at-")
                    .append(5 * i)
                    .append(": {model: packaged:quadrotor.obj, flight: {kind: hover, position: [")
                    .append(5 * i)
                    .append(", 20, 20]}}\n");
        }
        Path file = directory.resolve("site.yaml");
        Files.writeString(
                file,
                "world: {models: [packaged:house.obj" + models + "]}\ndrones:\n" + drones
                        + "sensors:\n  camera: {kind: camera, position: [0, 0, 20], fov: 60 deg}\nrun: {duration: 0.01 s}\n");
        Files.writeString(directory.resolve("housing.obj"), HOUSING);
        List<Observation> seen = new ArrayList<>();
        new SceneRunner(new SceneFile(file))
                .onFrame(frame -> seen.addAll(frame.observations()))
                .run();
        return seen.stream().map(Observation::value).toList();
    }

    /** Its edge at 0.35 m of 1 m hides what is up to 7 m aside at 20 m. */
    @Test
    void aHousingHidesWhatIsBehindItAndNoMore() throws IOException {
        List<Double> free = pixels("");
        assertThat(free).hasSize(3).allMatch(count -> count > 50);
        assertThat(pixels(", housing.obj")).containsExactly(0.0, 0.0, free.get(2));
    }
}
