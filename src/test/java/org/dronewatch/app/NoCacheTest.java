package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.dronewatch.Thorough;
import org.dronewatch.run.store.KeptTerrain;
import org.dronewatch.run.store.StorePlace;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What {@code --no-cache} does, and that only the command to which it is given sees it. */
class NoCacheTest {
    private static final String SCENE =
            """
            world:
              origin: {latitude: 50 deg, longitude: 15 deg, height: 230}
              terrain: {file: dem.asc, crs: "EPSG:4326", radius: 60 m}
            sensors:
              radio: {use: droneshield-rfone, position: {east: 0, north: 0, above: 2}}
            drones:
              visitor:
                model: packaged:quadrotor.obj
                flight: {kind: approach, from: [0, 30, 20], to: [0, 0, 10]}
            run: {duration: 1}
            """;

    private static String seen;

    @TempDir
    private Path directory;

    private Path file;
    private KeptTerrain kept;
    private String before;

    /** Finds out whether the property has changed while a command describes the scene. */
    public static final class Watching extends Scene {
        private static final long serialVersionUID = 1L;

        @Override
        protected void build() {
            seen = System.getProperty(StorePlace.PROPERTY);
            loadWorld(loadPackaged("hill.obj"));
        }
    }

    @BeforeEach
    void keepTerrain() throws IOException {
        StringBuilder posts = new StringBuilder(
                "ncols 23\nnrows 23\nxllcenter 14.9989\nyllcenter 49.9989\ncellsize 0.0001\nNODATA_value -9999\n");
        for (int i = 0; i < 23 * 23; i++) {
            posts.append(230 + i * 7 % 13).append(i % 23 == 22 ? '\n' : ' ');
        }
        Files.writeString(directory.resolve("dem.asc"), posts);
        file = Files.writeString(directory.resolve("site.yaml"), SCENE);
        Files.writeString(directory.resolve("two.yaml"), "scene: site.yaml\nruns: 2\n");
        Files.writeString(
                directory.resolve("site.place.yaml"),
                """
                scene: site.yaml
                budget: 1
                candidates: {mast: {sensor: {use: droneshield-rfone}, places: [[0, 0, 20]], price: 1}}
                air: {side: 40 m, cell: 20 m, heights: [10 m]}
                """);
        before = System.getProperty(StorePlace.PROPERTY);
        Path store = directory.resolve("store");
        kept = new KeptTerrain(
                new SceneRunner(new SceneFile(file))
                        .store(StorePlace.NONE)
                        .settings()
                        .world(),
                directory,
                store);
        System.setProperty(StorePlace.PROPERTY, store.toString());
    }

    @AfterEach
    void restorePlace() {
        if (before == null) {
            System.clearProperty(StorePlace.PROPERTY);
        } else {
            System.setProperty(StorePlace.PROPERTY, before);
        }
    }

    private static void execute(List<String> arguments) {
        StringWriter err = new StringWriter();
        int code = Main.execute(
                new PrintWriter(Writer.nullWriter()), new PrintWriter(err), arguments.toArray(String[]::new));
        assertThat(code).as(err.toString()).isZero();
    }

    @Thorough
    @ParameterizedTest
    @ValueSource(
            strings = {
                "check DIR/site.yaml",
                "height DIR/site.yaml --at 50,15",
                "run DIR/site.yaml --out DIR/run",
                "render DIR/site.yaml --view top --size 64x64 --out DIR/picture.png",
                "coverage DIR/site.yaml --heights=10 --side=40 --cell=20",
                "route DIR/site.yaml --heights=10 --side=80 --cell=20",
                "place DIR/site.place.yaml",
                "campaign DIR/two.yaml --out DIR/campaign",
                "compare DIR/site.yaml --with run.duration=2 --runs=2"
            })
    void aCommandNeitherUsesTheStoreNorAddsToIt(String words) {
        List<String> command = new ArrayList<>(
                Arrays.asList(words.replace("DIR", directory.toString()).split(" ")));
        assertThat(kept.isUsedBy(() -> execute(command))).isTrue();
        for (int i = 0; i < command.size(); i++) {
            command.set(i, command.get(i).replaceFirst("/(run|campaign)$", "/another-$1"));
        }
        command.add("--no-cache");
        assertThat(kept.isUsedBy(() -> execute(command))).isFalse();
    }

    @Thorough
    @Test
    void whatIsRepeatedDoesNotUseTheStoreEither() {
        String run = directory.resolve("run").toString();
        execute(List.of("run", file.toString(), "--out", run, "--no-cache"));
        List<String> again = List.of("again", run + "/provenance.json");
        assertThat(kept.isUsedBy(() -> execute(again))).isTrue();
        List<String> without = new ArrayList<>(again);
        without.add("--no-cache");
        assertThat(kept.isUsedBy(() -> execute(without))).isFalse();
    }

    @Test
    void nothingElseInTheProcessSeesIt() {
        String place = System.getProperty(StorePlace.PROPERTY);
        execute(List.of("check", Watching.class.getName(), "--no-cache"));
        assertThat(seen).isEqualTo(place);
        assertThat(System.getProperty(StorePlace.PROPERTY)).isEqualTo(place);
    }
}
