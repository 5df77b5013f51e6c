package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Models whose heights or units do not fit the site, as a user meets them: `check` says so, in one line each. */
class ModelOnGroundTest extends CommandLines {
    /** Ground that rises by a metre in ten to the east, 200 m above the sea at the origin. */
    @BeforeEach
    void writeGround() throws IOException {
        StringBuilder text =
                new StringBuilder("ncols 41\nnrows 41\nxllcenter 499800\nyllcenter 5538430.74\ncellsize 10\n");
        for (int row = 0; row < 41; row++) {
            for (int column = 0; column < 41; column++) {
                text.append(180 + column).append(' ');
            }
            text.append('\n');
        }
        Files.writeString(directory.resolve("ground.asc"), text);
    }

    /** The lines of warnings about the models of a scene on this ground. */
    private List<String> warnings(String terrain, String models) throws IOException {
        Files.writeString(
                directory.resolve("scene.yaml"),
                "world:\n  origin: {latitude: 50.0 deg, longitude: 15.0 deg, height: 200 m}\n" + terrain + "  models: ["
                        + models + "]\n");
        Program.Outcome check = commandIn("check DIR/scene.yaml");
        assertThat(check.code()).as(check.err()).isZero();
        return check.err()
                .lines()
                .filter(line -> line.startsWith("warning: "))
                .map(line -> line.replace(directory + "/", "").substring(9))
                .toList();
    }

    private static final String GROUND = "  terrain: {file: ground.asc, crs: EPSG:32633, accuracy: 0}\n";

    /** A box with a separate chimney on its roof: the lowest point of the chimney does not count. */
    private static String house(double x, double y, double z, double size) {
        StringBuilder text = new StringBuilder();
        box(text, x, y, z, size);
        box(text, x + 0.25 * size, y + 0.25 * size, z + size, 0.25 * size);
        return text.toString();
    }

    private static void box(StringBuilder text, double x, double y, double z, double size) {
        for (int i = 0; i < 8; i++) {
            text.append("v ").append(x + size * (i & 1)).append(' ').append(y + size * (i >> 1 & 1));
            text.append(' ').append(z + size * (i >> 2)).append('\n');
        }
        text.append("f -8 -6 -5 -7\nf -4 -3 -1 -2\nf -8 -7 -3 -4\nf -6 -2 -1 -5\nf -8 -4 -2 -6\nf -7 -5 -1 -3\n");
    }

    private void write(String name, String text) throws IOException {
        Files.writeString(directory.resolve(name), text);
    }

    /** At x, the ground is at x / 10, and that of the west corner is the lowest. */
    @ParameterizedTest
    @CsvSource({"46.3, above, 46.3", "-8, below, 8.0", "3.1, above, 3.1", "2.9, '', 0", "0, '', 0", "-2.9, '', 0"})
    void aHouseOffTheGroundIsDoubted(double offset, String side, String shown) throws IOException {
        write("house.obj", house(50, 0, 5.0 + offset, 10));
        List<String> lines = warnings(GROUND, "{file: house.obj, upAxis: z}");
        if (side.isEmpty()) {
            assertThat(lines).isEmpty();
        } else {
            assertThat(lines)
                    .containsExactly("house.obj: its lowest point lies " + shown + " m " + side
                            + " the ground: its heights may refer to a different vertical datum; if so, correct them with"
                            + " world.models.0.position");
        }
    }

    /** Five houses, three of which hover by 40, 48 and 50 m; one lies beyond the ground, where nothing is known. */
    @Test
    void ofATownTheMedianCounts() throws IOException {
        StringBuilder mast = new StringBuilder();
        box(mast, 0, -100, 0, 1);
        write("mast.obj", mast.toString());
        write(
                "town.obj",
                house(-150, 0, -15, 10)
                        + house(-50, 0, -5 + 40, 10)
                        + house(0, 0, 48, 10)
                        + house(50, 0, 5 + 50, 10)
                        + house(100, 50, 10 + 47, 10)
                        + house(900, 0, 90, 10));
        assertThat(warnings(GROUND, "{file: mast.obj, upAxis: z, role: other}, {file: town.obj, upAxis: z}"))
                .hasSize(1)
                .allMatch(line -> line.startsWith("town.obj: its lowest points lie 47.0 m above the ground (median of 5"
                                + " separate parts): ")
                        && line.endsWith("world.models.1.position"));
    }

    /** A mast of 5 m on the roof of a house, its roots a metre inside; plants and other things may hover. */
    @Test
    void whatStandsOnARoofIsOnTheGround() throws IOException {
        write("house.obj", house(50, 0, 4, 10));
        StringBuilder mast = new StringBuilder();
        box(mast, 58, 8, 13, 1);
        write("mast.obj", mast.toString());
        assertThat(warnings(GROUND, "{file: house.obj, upAxis: z}, {file: mast.obj, upAxis: z}"))
                .isEmpty();
        assertThat(warnings(GROUND, "{file: mast.obj, upAxis: z}")).hasSize(1);
        assertThat(warnings(GROUND, "{file: mast.obj, upAxis: z, role: other}")).isEmpty();
        assertThat(warnings("", "{file: mast.obj, upAxis: z}")).isEmpty();
    }

    /** A house of 20 m in millimetres, in each format; with the scale, it stands as it should. */
    @ParameterizedTest
    @ValueSource(strings = {"obj", "ply"})
    void aHouseInMillimetresIsDoubted(String format) throws IOException {
        String name = "house." + format;
        write(name, format.equals("obj") ? house(0, 0, 0, 16_000) : ply(16_000));
        assertThat(warnings("", "{file: " + name + ", upAxis: z}"))
                .hasSize(1)
                .allMatch(line -> line.startsWith(name + ": is 16,000 m x 16,000 m x ")
                        && line.contains("set its scale, as in scale: 0.001 for millimetres"));
        assertThat(warnings("", "{file: " + name + ", upAxis: z, scale: 0.001}"))
                .isEmpty();
        assertThat(warnings("", "{file: " + name + ", upAxis: z, scale: 0.000001}"))
                .hasSize(1)
                .allMatch(line -> line.contains("too small to hide anything: check its scale"));
        assertThat(warnings("", "{file: " + name + ", upAxis: z, role: terrain}"))
                .isEmpty();
    }

    /** A drone of 400 m x 300 m in place of millimetres; the quadrotor of the library has 0.6 m. */
    @Test
    void aDroneInMillimetresIsDoubted() throws IOException {
        write("drone.ply", ply(400));
        write(
                "scene.yaml",
                "world: {models: [packaged:hill.obj]}\ndrones:\n"
                        + "  a: {model: {file: drone.ply, upAxis: z}, flight: {kind: hover, position: [0, 0, 900]}}\n"
                        + "  b: {model: {file: drone.ply, upAxis: z, scale: 0.001}, flight: {kind: hover, position: [0, 0, 150]}}\n"
                        + "  c: {model: packaged:quadrotor.obj, flight: {kind: hover, position: [9, 0, 150]}}\n");
        Program.Outcome check = commandIn("check DIR/scene.yaml");
        assertThat(check.err().lines().filter(line -> line.startsWith("warning: ")))
                .containsExactly("warning: drone 'a': its model is 400 m across: unless its unit is the metre, set"
                        + " drones.a.model.scale, as in scale: 0.001 for millimetres");
    }

    private static String ply(double size) {
        return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                + "element face 4\nproperty list uchar int vertex_index\nend_header\n0 0 0\n" + size + " 0 0\n0 " + size
                + " 0\n0 0 " + size + "\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
    }
}
