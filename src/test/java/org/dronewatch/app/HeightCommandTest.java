package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class HeightCommandTest extends CommandLines {
    /**
     * A plane that rises by 0.1 to the east, from 210 m at the origin; without heights in the north. A table stands on
     * it.
     */
    @BeforeEach
    void writeSite() throws IOException {
        StringBuilder text = new StringBuilder(
                "ncols 41\nnrows 41\nxllcenter 499900\nyllcenter 5538530.74\ncellsize 5\nNODATA_value -9999\n");
        for (int row = 0; row < 41; row++) {
            for (int column = 0; column < 41; column++) {
                text.append(row < 10 ? "-9999 " : (210 + 0.5 * (column - 20)) + " ");
            }
            text.append('\n');
        }
        Files.writeString(directory.resolve("ground.asc"), text);
        Files.writeString(
                directory.resolve("table.obj"),
                """
                v 10 15 -5
                v 30 15 -5
                v 30 15 5
                v 10 15 5
                v 10 14 -5
                v 30 14 -5
                v 30 14 5
                v 10 14 5
                usemtl wood
                f 4 3 2 1
                f 5 6 7 8
                """);
        Files.writeString(
                directory.resolve("site.yaml"),
                """
                world:
                  origin: {latitude: 50.0 deg, longitude: 15.0 deg, height: 200 m}
                  terrain: {file: ground.asc, crs: EPSG:32633, accuracy: 0}
                  models: [table.obj]
                """);
    }

    private String height(String place) {
        Program.Outcome outcome =
                Program.run("height", directory.resolve("site.yaml").toString(), "--at", place);
        assertThat(outcome.code()).as(outcome.err()).isZero();
        return outcome.out();
    }

    @Test
    void groundSurfaceAndWhatIsThere() {
        assertThat(height("{east: 20, north: 2, above: 3 m}").lines())
                .containsExactly(
                        "place: latitude 50.000018 deg, longitude 15.000279 deg",
                        "place: x 20.00 m, y 2.00 m, z 18.00 m, 3.00 m above the surface",
                        "surface: z 15.00 m, 215.00 m above sea level, 3.00 m above the ground: building of table.obj, wood",
                        "below: z 14.00 m, 214.00 m above sea level, 2.00 m above the ground: building of table.obj, wood,"
                                + " facing down",
                        "ground: z 12.00 m, 212.00 m above sea level: terrain of ground.asc, pasture_uncompacted");
        assertThat(height("50,15").lines())
                .containsExactly(
                        "place: latitude 50.000000 deg, longitude 15.000000 deg",
                        "place: x 0.00 m, y 0.00 m, z 10.00 m, 0.00 m above the surface",
                        "ground and surface: z 10.00 m, 210.00 m above sea level: terrain of ground.asc, pasture_uncompacted");
        assertThat(height("[0, -20, 5]")).contains("z 5.00 m, -5.00 m above the surface");
    }

    /** A scene without an origin and without terrain: the ground is what lies lowest and faces up. */
    @Test
    void modelsAloneHaveHeightsToo() throws IOException {
        Files.writeString(directory.resolve("site.yaml"), "world: {models: [table.obj]}\n");
        assertThat(height("{east: 20, north: 2}").lines())
                .containsExactly(
                        "place: x 20.00 m, y 2.00 m, z 15.00 m, 0.00 m above the surface",
                        "ground and surface: z 15.00 m: building of table.obj, wood",
                        "below: z 14.00 m: building of table.obj, wood, facing down");
    }

    @Test
    void whatIsNoPlaceOrHasNoGroundIsRefused() throws IOException {
        assertThat(refusal("50.0005,15")).contains("no surface at latitude 50.000500 deg, longitude 15.000000 deg");
        assertThat(refusal("[0, 80, 5]"))
                .contains("--at [0, 80, 5]: no surface at x 0.0 m, y 80.0 m: the site has a hole");
        assertThat(refusal("91,15")).isEqualTo("--at 91,15: latitude 91 deg must be -90 to 90 deg");
        assertThat(refusal("{lat: 50 deg, longitude: 15 deg}"))
                .isEqualTo("--at {lat: 50 deg, longitude: 15 deg}: unknown setting 'lat'; did you mean 'latitude'?"
                        + " (latitude, longitude, above, height)");
        assertThat(refusal("[1, 2")).contains("is not valid YAML");
        assertThat(refusal("")).startsWith("--at : ");
        assertThat(refusal("x\ny: 3")).startsWith("--at ");
        Files.writeString(directory.resolve("site.yaml"), "world: {models: [table.obj]}\n");
        assertThat(refusal("50,15")).contains("needs a world.origin");
        assertThat(commandIn("height DIR/site.yaml").code()).isEqualTo(2);
    }

    private String refusal(String place) {
        Program.Outcome outcome =
                Program.run("height", directory.resolve("site.yaml").toString(), "--at", place);
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.out()).isEmpty();
        return outcome.err().lines().reduce((a, b) -> b).orElseThrow();
    }
}
