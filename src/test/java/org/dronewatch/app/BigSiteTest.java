package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;

/**
 * Ground of 10 x 10 km with two million triangles, and 20,000 buildings: it runs within 4 GB, and gives the same
 * results without the cache, with an empty one, and with a filled one. Prints the times.
 */
class BigSiteTest {
    private static final int SIDE = 1001;
    private static final int HOUSES = 20_000;

    /** What contains times, dates or the command. */
    private static final List<String> OWN = List.of("summary.json", "provenance.json", "report.html");

    private static final String SCENE =
            """
            world:
              origin: {latitude: 48 deg, longitude: 9 deg, height: 300}
              terrain: {file: dem.asc, crs: EPSG:32632, radius: 7 km, accuracy: 0}
              buildings: {file: town.osm, radius: 7 km}
            run: {duration: 2}
            drones:
              a: {model: packaged:quadrotor.obj, speed: 18 m/s,
                flight: {kind: waypoints, points: [[-2000, 100, 150], [2000, 50, 150]]}}
            sensors:
              camera: {kind: camera, position: {east: 0 m, north: 0 m, above: 6 m}, aim: {azimuth: 270 deg, elevation: 3 deg}}
              radio: {kind: rf, position: {east: 2 m, north: 0 m, above: 9 m}}
            """;

    @TempDir
    private Path directory;

    private final SplittableRandom random = new SplittableRandom(1);

    /** Some minutes' work: asked for by whoever changes how sites are prepared. */
    @Test
    @EnabledIfSystemProperty(named = "dronewatch.big", matches = "run")
    void aBigSiteRunsAndIsFoundAgain() throws IOException, InterruptedException {
        Files.writeString(directory.resolve("big.yaml"), SCENE);
        writeGround();
        writeTown();

        List<String> without = run("without", "off");
        List<String> first = run("first", "cache");
        List<String> second = run("second", "cache");

        assertThat(first).isEqualTo(without);
        assertThat(second).isEqualTo(without);
        try (Stream<Path> results = Files.list(directory.resolve("without"))) {
            for (Path result : results.filter(Files::isRegularFile).toList()) {
                String name = result.getFileName().toString();
                if (!OWN.contains(name)) {
                    assertThat(directory.resolve("first").resolve(name)).hasSameBinaryContentAs(result);
                    assertThat(directory.resolve("second").resolve(name)).hasSameBinaryContentAs(result);
                }
            }
        }
    }

    /** What it said, but for what took time. */
    private List<String> run(String out, String cache) throws IOException, InterruptedException {
        List<String> options = List.of("-XX:TieredStopAtLevel=4", "-Xmx4g", "-Ddronewatch.cache=" + cache);
        long start = System.nanoTime();
        try (Program.Child child = Program.start(directory, options, "run", "big.yaml", "--out", out)) {
            assertThat(child.process().waitFor(10, TimeUnit.MINUTES)).isTrue();
            assertThat(child.process().exitValue())
                    .as(Files.readString(child.err()))
                    .isZero();
            System.out.printf(Locale.ROOT, "%s: %.1f s in all%n", out, 1e-9 * (System.nanoTime() - start));
            Files.readAllLines(directory.resolve(out).resolve("summary.json")).stream()
                    .filter(line -> line.matches(" *\"(load|build|wall)_s\".*"))
                    .forEach(System.out::println);
            return Files.readAllLines(child.err()).stream()
                    .filter(line -> !line.endsWith(" ...") && !line.startsWith("results in "))
                    .toList();
        }
    }

    /** Posts 10 m apart, hills and noise. */
    private void writeGround() throws IOException {
        try (BufferedWriter file = Files.newBufferedWriter(directory.resolve("dem.asc"))) {
            file.write(String.format(
                    Locale.ROOT,
                    "ncols %d%nnrows %d%nxllcenter 495000%nyllcenter 5311300%ncellsize 10%nNODATA_value -9999%n",
                    SIDE,
                    SIDE));
            for (int row = 0; row < SIDE; row++) {
                StringBuilder line = new StringBuilder();
                for (int column = 0; column < SIDE; column++) {
                    double hills = 60.0 * Math.sin(row / 60.0) * Math.cos(column / 70.0);
                    double slopes = 8.0 * Math.sin(column / 9.0 + row / 11.0);
                    long cm = Math.round(100.0 * (300.0 + hills + slopes + 0.3 * random.nextDouble()));
                    line.append(cm / 100).append('.').append(cm % 100 / 10).append(cm % 10);
                    line.append(' ');
                }
                file.write(line.append('\n').toString());
            }
        }
    }

    /** Houses with six corners on a grid of 69 m. */
    private void writeTown() throws IOException {
        try (BufferedWriter file = Files.newBufferedWriter(directory.resolve("town.osm"))) {
            file.write("<osm version=\"0.6\">\n");
            StringBuilder ways = new StringBuilder();
            for (int house = 0; house < HOUSES; house++) {
                double x = -4900.0 + house / 142 * 69.0;
                double y = -4900.0 + house % 142 * 69.0;
                double width = 12.0 + 20.0 * random.nextDouble();
                double depth = 10.0 + 15.0 * random.nextDouble();
                double[] east = {0, width, width, width / 2, width / 2, 0};
                double[] north = {0, 0, depth, depth, 1.4 * depth, 1.4 * depth};
                ways.append("<way id=\"").append(house + 1).append("\">");
                for (int i = 0; i <= 6; i++) {
                    if (i < 6) {
                        file.write(String.format(
                                Locale.ROOT,
                                "<node id=\"%d\" lat=\"%.7f\" lon=\"%.7f\"/>%n",
                                6 * house + i + 1,
                                48.0 + (y + north[i]) / 111_200.0,
                                9.0 + (x + east[i]) / 74_490.0));
                    }
                    ways.append("<nd ref=\"").append(6 * house + i % 6 + 1).append("\"/>");
                }
                ways.append("<tag k=\"building\" v=\"yes\"/><tag k=\"height\" v=\"")
                        .append(3 + random.nextInt(20))
                        .append("\"/></way>\n");
            }
            file.write(ways + "</osm>\n");
        }
    }
}
