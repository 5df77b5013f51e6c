package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.app.Program.Outcome;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The coverage at several heights, as the command prints and writes it. */
class CoverageCommandTest {
    @TempDir
    private static Path directory;

    private static Outcome outcome;
    private static JsonNode json;

    @BeforeAll
    static void run() throws IOException {
        FieldSite.in(directory, FieldSite.ROUND + "  radio: {kind: rf, position: [0, 5, 4], threshold: 45}\n");
        outcome = coverage("1", "field");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        json = JsonMapper.builder()
                .build()
                .readTree(directory.resolve("field/coverage.json").toFile());
    }

    private static Outcome coverage(String threads, String out) {
        return Program.run(
                "coverage",
                directory.resolve("site.yaml").toString(),
                "--heights=2,60m",
                "--side=300",
                "--cell=20m",
                "--heading=best",
                "--covered=0.9",
                "--threads=" + threads,
                "--out=" + directory.resolve(out));
    }

    @Test
    void theFileStatesWhatWasAskedAndWhatWasFound() {
        assertThat(json.propertyNames())
                .containsExactly(
                        "format",
                        "scene",
                        "drone",
                        "covered",
                        "within_s",
                        "heading",
                        "pointing",
                        "area",
                        "cell_m",
                        "cells_per_side",
                        "west_m",
                        "north_m",
                        "heights",
                        "idle_sensors",
                        "covered_again_gap",
                        "warning",
                        "conditions",
                        "complete");
        assertThat(json.get("heading").asString()).isEqualTo("best");
        assertThat(json.get("covered").asDouble()).isEqualTo(0.9);
        assertThat(json.get("cells_per_side").asInt()).isEqualTo(15);
        assertThat(json.get("west_m").asDouble()).isEqualTo(-150.0);
        assertThat(json.get("north_m").asDouble()).isEqualTo(152.5);
        assertThat(json.get("within_s").isNull()).isTrue();
        assertThat(json.get("area").isNull()).isTrue();
        assertThat(json.get("complete").asBoolean()).isTrue();
        JsonNode low = json.get("heights").get(0);
        assertThat(low.propertyNames())
                .containsExactly(
                        "height_m",
                        "known",
                        "unknown_share",
                        "inside_share",
                        "covered_share",
                        "visible_share",
                        "detectable_share",
                        "volume_m3",
                        "causes",
                        "causes_by_sensor",
                        "count_shares",
                        "n_minus_1",
                        "largest_gap_m2",
                        "gap");
        assertThat(low.get("gap").propertyNames()).containsExactly("x", "y", "cause", "touches_rim");
    }

    /** Fractions of one whole add up to it, and what is covered is what the radar and the receiver cover. */
    @Test
    void sharesAddUp() {
        for (JsonNode height : json.get("heights")) {
            double inside = height.get("inside_share").asDouble();
            assertThat(height.get("known").asInt()).isEqualTo((int) Math.round((1 - inside) * 225));
            assertThat(sum(height.get("causes"))).isCloseTo(1.0, within(1e-5));
            assertThat(height.get("causes_by_sensor").propertyNames()).containsExactly("round", "radio");
            height.get("causes_by_sensor")
                    .forEach(causes -> assertThat(sum(causes)).isCloseTo(1.0, within(1e-5)));
            assertThat(sum(height.get("count_shares"))).isCloseTo(1.0, within(1e-5));
            JsonNode none = height.get("count_shares").path("0");
            assertThat(height.get("covered_share").asDouble()).isCloseTo(1.0 - none.asDouble(), within(1e-5));
            assertThat(height.get("detectable_share").asDouble())
                    .isBetween((1 - inside) * height.get("covered_share").asDouble() - 1e-5, 1.0);
            assertThat(height.get("n_minus_1").propertyNames()).containsExactly("round", "radio");
        }
        JsonNode low = json.get("heights").get(0);
        JsonNode high = json.get("heights").get(1);
        assertThat(low.get("inside_share").asDouble()).isPositive();
        assertThat(high.get("inside_share").asDouble()).isZero();
        assertThat(low.get("visible_share").asDouble()).isBetween(0.5, 0.99);
        assertThat(high.get("visible_share").asDouble()).isBetween(0.95, 1.0);
        assertThat(low.get("n_minus_1").get("round").asDouble()).isPositive();
    }

    private static double sum(JsonNode shares) {
        double sum = 0.0;
        for (JsonNode share : shares) {
            sum += share.asDouble();
        }
        return sum;
    }

    @Test
    void theTablesAreThoseOfTheFile() {
        String covered = String.format(
                "%.1f", 100 * json.get("heights").get(0).get("covered_share").asDouble());
        assertThat(outcome.out().lines()).anyMatch(line -> line.matches(" +2 m +2\\d\\d +" + covered + " .*"));
        assertThat(outcome.out())
                .contains("clear line of sight at or below a height")
                .contains("any of them")
                .contains("largest gap:")
                .contains("coverage lost if one sensor is removed");
    }

    /** The receiver comes nearest to a detection everywhere: it must not hide that the radar is blind. */
    @Test
    void theCausesOfEachSensorAreStatedEvenIfAnotherOneDecides() {
        List<String> worst = causes("worst");
        int at = worst.indexOf(
                "what each sensor detects by itself, and why it misses the rest, in % of the known cells at all heights:");
        assertThat(worst.subList(0, at)).noneMatch(line -> line.contains("too slow"));
        assertThat(worst.get(at + 1)).matches("sensor +detected +.*too slow .*signal too weak");
        assertThat(worst.get(at + 2)).matches("round +- .*");
        assertThat(worst.get(at + 3)).matches("radio .*");
        assertThat(worst.get(at + 4))
                .isEqualTo("too slow: hovering, or flying across a radar's line of sight; what is detected on other"
                        + " headings is shown by --heading best or inbound");
        assertThat(causes("inbound")).noneMatch(line -> line.startsWith("too slow:"));
    }

    /** The first twelve of fifteen sensors are printed; the others are where the line says. */
    @Test
    void aTableThatIsCutSaysWhereTheRestIs() throws IOException {
        Path many = Files.createDirectories(directory.resolve("many"));
        StringBuilder sensors = new StringBuilder();
        for (int i = 0; i < 15; i++) {
            sensors.append("  radio-").append(i).append(": {kind: rf, position: [0, 0, 10]}\n");
        }
        FieldSite.in(many, sensors.toString());
        List<String> command = new ArrayList<>(
                List.of("coverage", many.resolve("site.yaml").toString(), "--heights=60m", "--side=40", "--cell=20m"));
        assertThat(Program.run(command.toArray(String[]::new)).out().lines())
                .contains("and 3 more sensors (--out DIR writes all of them to report.html)");
        Path out = many.resolve("field");
        command.add("--out=" + out);
        assertThat(Program.run(command.toArray(String[]::new)).out().lines())
                .contains("and 3 more sensors (see " + out.resolve("report.html") + ")");
        assertThat(Files.readString(out.resolve("report.html"))).contains(">radio-14<");
    }

    /** The radar is blind on the worst heading, and the receiver is not: the file does not mix them up. */
    @Test
    void theFileStatesTheCausesOfEachSensor() {
        JsonNode high = json.get("heights").get(1).get("causes_by_sensor");
        assertThat(high.get("radio").propertyNames()).doesNotContain("out-of-view", "too-slow");
        assertThat(high.get("round").propertyNames()).contains("out-of-range").doesNotContain("silent");
    }

    private static List<String> causes(String heading) {
        Outcome found = Program.run(
                "coverage",
                directory.resolve("site.yaml").toString(),
                "--heights=60m",
                "--side=200",
                "--cell=20m",
                "--heading=" + heading);
        assertThat(found.code()).as(found.err()).isZero();
        return found.out().lines().toList();
    }

    @Test
    void anyNumberOfThreadsWritesTheSameBytes() throws IOException {
        assertThat(coverage("8", "again").out()).isEqualTo(outcome.out());
        List<Path> files;
        try (Stream<Path> all = Files.list(directory.resolve("field"))) {
            files = all.sorted().toList();
        }
        assertThat(files)
                .extracting(file -> file.getFileName().toString())
                .containsExactly(
                        "cause-2.png",
                        "cause-60.png",
                        "coverage.json",
                        "min-height.png",
                        "report.html",
                        "visible-height.png",
                        "warning.png");
        for (Path file : files) {
            Path again = directory.resolve("again").resolve(file.getFileName());
            if (file.endsWith("report.html")) {
                assertThat(withoutProvenance(again)).isEqualTo(withoutProvenance(file));
            } else {
                assertThat(again).as(file.toString()).hasSameBinaryContentAs(file);
            }
        }
    }

    /** The command, the date and the number of threads are in the provenance alone. */
    private static String withoutProvenance(Path report) throws IOException {
        String page = Files.readString(report);
        assertThat(page).contains("<h2>Provenance</h2>", "--cell=20m", "SHA-256 of site.yaml");
        return page.substring(0, page.indexOf("<h2>Provenance</h2>"));
    }

    /** A radar that rarely detects the drone in one look, but often in a hundred; in a yard. */
    @Test
    void moreTimeCoversMore() throws IOException {
        Path site = Files.createDirectories(directory.resolve("patient"));
        FieldSite.in(
                site,
                """
                  far: {kind: radar, position: [0, 0, 4], minRange: 1, maxRange: 400, elevationWidth: 90 deg, minSpeed: 0 m/s,
                    rate: 2, budget: {range: 70, crossSection: 0.01}, detection: {kind: chance, pulses: 8}}
                alert:
                  zones:
                    yard: {area: [[-90, -90], [90, -90], [90, 90]], height: 40}
                """);
        Outcome outcome = Program.run(
                "coverage",
                site.resolve("site.yaml").toString(),
                "--heights=60",
                "--cell=20",
                "--within=50s",
                "--area=yard",
                "--out=" + site.resolve("yard"));
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.out())
                .contains(
                        "known cells in 'yard' at each height, covered within 50 s, and causes of misses in single looks:")
                .contains("from a distance of 385 m");
        JsonNode file = JsonMapper.builder()
                .build()
                .readTree(site.resolve("yard/coverage.json").toFile());
        assertThat(file.get("area").asString()).isEqualTo("yard");
        assertThat(file.get("within_s").asDouble()).isEqualTo(50.0);
        JsonNode height = file.get("heights").get(0);
        double known = height.get("known").asInt();
        double covered = height.get("covered_share").asDouble();
        assertThat(known).as("a triangle of 81 cells").isBetween(32.0, 46.0);
        assertThat(height.get("unknown_share").asDouble()).isZero();
        assertThat(covered)
                .isGreaterThan(height.get("causes").path("detected").asDouble() + 0.1)
                .isLessThan(0.95);
        int blue = blue(ImageIO.read(site.resolve("yard/cause-60.png").toFile()));
        assertThat(blue).as("pixels shown as detected").isCloseTo((int) (covered * known / 81 * 1e6), within(20_000));
    }

    private static int blue(BufferedImage map) {
        int blue = 0;
        for (int x = 0; x < 1000; x++) {
            for (int y = 0; y < 1000; y++) {
                blue += (map.getRGB(x, y) & 0xff) > (map.getRGB(x, y) >> 16 & 0xff) + 20 ? 1 : 0;
            }
        }
        return blue;
    }

    /** One line for each wrong option. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--centre=7 | --centre 7: must be EAST,NORTH, such as 100m,-50m",
                "--centre=7,1e9 | --centre 1e9: north 1e9 m must be -100000 to 100000",
                "--within=0 | --within 0: within 0 s must be above 0 and at most 86400",
                "--within= | --within: ''",
                "--heights= | --heights: ''",
                "--heights=10, | --heights: ''",
                "--centre= | --centre: must be EAST,NORTH",
                "--centre=,5 | --centre: ''",
                "--area= | --area: no such zone",
                "--drone= | --drone: no such drone",
                "--cell= | --cell: ''",
                "--side= | --side: ''",
                "--heights=10,10.0000001 | --heights: height 10.0000001 m after 10.0 m: heights must be in ascending order",
                "--heights=1e-7 | --heights: height 1.0E-7 m after 0.0 m: heights must be in ascending order",
                "--side=10m --cell=100m | --cell: a cell of 100.0 m is longer than the side of the area, 10.0 m",
                "--covered=0.001 | --covered 0.001: must be 0.008 to 0.996, or 1, since probabilities are kept in steps of",
                "--covered=0.999 | --covered 0.999: must be 0.008 to 0.996, or 1, since",
                "--covered=0 | --covered 0: must be 0.008 to 0.996, or 1, since",
                "--within=soon | --within soon: 'soon'",
                "--area=yard | --area yard: no such zone; the scene protects hook, protected",
                "--area=protected --side=100 | --area protected: cannot be combined with --side",
                "--area=hook --cell=90 | --cell 90.0 m: must be smaller, since no cell has its centre in 'hook'",
                "--within=5 --out=plan.png | --within: has no effect on a plan",
                "--area=protected --out=plan.png | --area: has no effect on a plan",
            })
    void wrongOptionsAreExplained(String options, String message) throws IOException {
        Path scene = Files.createDirectories(directory.resolve("wrong"));
        FieldSite.in(
                scene,
                FieldSite.ROUND
                        + """
                        alert:
                          protect: {centre: [80, 0, 10], radius: 30}
                          zones: {hook: {area: [[0, 0], [0, 50], [1, 50], [1, 1], [50, 1], [50, 0]], height: 9}}
                        """);
        List<String> command =
                new ArrayList<>(List.of("coverage", scene.resolve("site.yaml").toString()));
        command.addAll(List.of(options.split(" ")));
        Outcome wrong = Program.run(command.toArray(String[]::new));
        assertThat(wrong.code()).isEqualTo(2);
        assertThat(wrong.complaints()).singleElement().asString().startsWith(message);
    }

    /** Around a church nothing is known: neither the table nor the report speaks of the whole area. */
    @Test
    void howMuchIsUnknownIsStated() throws IOException {
        Path church = directory.resolve("church");
        Outcome outcome = Program.run(
                "coverage",
                "closed-space",
                "--side=90",
                "--cell=5",
                "--heights=2",
                "--set=sensors.microphone.enabled=false",
                "--out=" + church);
        assertThat(outcome.code()).as(outcome.err()).isZero();
        JsonNode file = JsonMapper.builder()
                .build()
                .readTree(church.resolve("coverage.json").toFile());
        double unknown = file.get("heights").get(0).get("unknown_share").asDouble();
        assertThat(unknown).isBetween(0.5, 0.95);
        String words = String.format(Locale.ROOT, "nknown: %.1f %% of the area: the ground there", 100.0 * unknown);
        assertThat(outcome.out()).contains("u" + words);
        assertThat(Files.readString(church.resolve("report.html")))
                .contains("U" + words, " of the known area at 2 m")
                .doesNotContain(" of the area at 2 m", "is detected everywhere.");
    }

    /** The area consists of whole cells, and a line says so where its side is another one. */
    @Test
    void anAreaOfWholeCellsIsStated() {
        String scene = directory.resolve("site.yaml").toString();
        Outcome rounded = Program.run("coverage", scene, "--heights=60", "--side=500", "--cell=200");
        assertThat(rounded.code()).as(rounded.err()).isZero();
        assertThat(rounded.err())
                .contains("the side of the area is 400 m instead of 500 m, so that it is a whole number of cells of 200"
                        + " m");
        for (String cell : List.of("--cell=0.1", "--cell=0.3")) {
            Outcome whole = Program.run("coverage", scene, "--heights=60", "--side=0.9", cell, "--centre=0,80");
            assertThat(whole.code()).as(whole.err()).isZero();
            assertThat(whole.err()).doesNotContain("whole number of cells");
        }
    }

    /** For each bearing and height; without a required response it cannot be in time or late. */
    @Test
    void theWarningIsStatedForEachBearing() {
        JsonNode warnings = json.get("warning");
        assertThat(warnings).hasSize(2 * 36);
        JsonNode east = warnings.get(9);
        assertThat(east.propertyNames())
                .containsExactly("bearing_deg", "height_m", "range_m", "warning_s", "at_least", "in_time");
        assertThat(east.get("bearing_deg").asDouble()).isEqualTo(90.0);
        assertThat(east.get("height_m").asDouble()).isEqualTo(2.0);
        assertThat(east.get("warning_s").asDouble())
                .isCloseTo(east.get("range_m").asDouble() / 12, within(1e-5));
        assertThat(east.get("in_time").isNull()).isTrue();
        assertThat(outcome.out())
                .contains(
                        "from a distance of 150 m: time from the first detection with a probability of 0.9 or more until they"
                                + " reach the centroid of the sensors:");
    }

    /** A pixel of the picture for each answer: the light blue of what is detected, the dark grey of what is solid. */
    @Test
    void thePicturesShowTheCells() throws IOException {
        BufferedImage causes =
                ImageIO.read(directory.resolve("field/cause-2.png").toFile());
        int near = pixel(causes, 12, -10);
        int solid = pixel(causes, 0, 65);
        assertThat(near & 0xff).as("blue").isGreaterThan((near >> 16 & 0xff) + 20);
        assertThat(solid & 0xff).isLessThan(0x60);
        BufferedImage visible =
                ImageIO.read(directory.resolve("field/visible-height.png").toFile());
        assertThat(visible.getWidth()).isEqualTo(causes.getWidth());
        int seen = pixel(visible, 12, -10);
        int behind = pixel(visible, 0, 85);
        assertThat(seen >> 8 & 0xff).as("lighter").isGreaterThan((behind >> 8 & 0xff) + 60);
        BufferedImage detectable =
                ImageIO.read(directory.resolve("field/min-height.png").toFile());
        assertThat(pixel(detectable, 12, -10)).as("at once").isEqualTo(seen);
        assertThat(pixel(detectable, 0, 85) >> 8 & 0xff).as("lighter").isLessThan(seen >> 8 & 0xff);
    }

    /** At the bottom of the legend of each map. */
    @Thorough
    @Test
    void everyMapShowsTheCreditsOfItsData() throws IOException {
        StringBuilder ground =
                new StringBuilder("ncols 9\nnrows 9\nxllcenter 499960\nyllcenter 5538590.74\ncellsize 10\n");
        Path site = Files.createDirectories(directory.resolve("survey"));
        Files.writeString(
                site.resolve("ground.asc"), ground.append("200 ".repeat(81)).append('\n'));
        String scene =
                """
                world:
                  origin: {latitude: 50.0 deg, longitude: 15.0 deg, height: 200 m}
                  terrain: {file: ground.asc, crs: EPSG:32633, attribution: "heights of the survey"}
                drones:
                  one: {model: packaged:quadrotor.obj, flight: {kind: hover, position: [10, 10, 12]}}
                sensors:
                  radio: {kind: rf, position: [0, 0, 10]}
                """;
        for (String attribution : List.of("heights of the survey", "")) {
            Path out = site.resolve("maps-" + attribution.length());
            Files.writeString(
                    site.resolve("site.yaml"),
                    attribution.isEmpty() ? scene.replaceFirst(", attribution: \"[^\"]*\"", "") : scene);
            Outcome outcome = Program.run(
                    "coverage",
                    site.resolve("site.yaml").toString(),
                    "--side=40",
                    "--cell=20",
                    "--heights=10",
                    "--out=" + out);
            assertThat(outcome.code()).as(outcome.err()).isZero();
            for (String map : List.of("cause-10", "visible-height", "min-height", "warning")) {
                assertThat(inkAtTheBottom(ImageIO.read(out.resolve(map + ".png").toFile())) > 100)
                        .as("%s with '%s'", map, attribution)
                        .isEqualTo(!attribution.isEmpty());
            }
        }
    }

    /** Files for maps need a place on earth; those of former heights, or of a former origin, do not stay. */
    @Test
    void filesForMapsAreWrittenWhereTheOriginIsKnown() throws IOException {
        Path site = directory.resolve("field.yaml");
        String text = Files.readString(directory.resolve("site.yaml"));
        Path out = directory.resolve("gis");
        Files.writeString(site, text.replace("world:\n", "world:\n  origin: {latitude: 50 deg, longitude: 15 deg}\n"));
        assertThat(coverage(site, "10", out).err()).doesNotContain("world.origin");
        assertThat(names(out))
                .contains(
                        "cause-10.tif",
                        "cause-10.tif.aux.xml",
                        "count-10.tif",
                        "min-height.tif",
                        "visible-height.tif",
                        "coverage.geojson",
                        "coverage.kml");
        Files.writeString(out.resolve("notes.tif"), "of the user");
        Files.writeString(site, text);
        assertThat(coverage(site, "20", out).err())
                .contains("the scene has no world.origin: no GeoTIFF, GeoJSON or KML files are written");
        assertThat(names(out))
                .containsExactly(
                        "cause-20.png",
                        "coverage.json",
                        "min-height.png",
                        "notes.tif",
                        "report.html",
                        "visible-height.png",
                        "warning.png");
    }

    /** Both have a report.html. */
    @Test
    void theResultsOfARunAreNotOverwritten() throws IOException {
        Path run = Files.createDirectory(directory.resolve("run"));
        Files.writeString(run.resolve("result.json"), "{}");
        Outcome outcome = Program.run(
                "coverage", directory.resolve("site.yaml").toString(), "--side=40", "--cell=20", "--out=" + run);
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.err()).contains("run holds the results of a run", "choose another directory");
        assertThat(names(run)).containsExactly("result.json");
    }

    @Test
    void aRunLeavesTheResultsOfACoverageAlone() throws IOException {
        Path field = Files.createDirectories(directory.resolve("a-field"));
        Files.writeString(field.resolve("coverage.json"), "{}");
        Outcome outcome = Program.run("run", directory.resolve("site.yaml").toString(), "--out=" + field);
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.err()).contains("a-field holds the results of 'coverage'", "choose another directory");
        assertThat(names(field)).containsExactly("coverage.json");
    }

    private static Outcome coverage(Path site, String heights, Path out) {
        Outcome outcome = Program.run(
                "coverage", site.toString(), "--side=40", "--cell=20", "--heights=" + heights, "--out=" + out);
        assertThat(outcome.code()).as(outcome.err()).isZero();
        return outcome;
    }

    private static List<String> names(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }

    private static int inkAtTheBottom(BufferedImage map) {
        int ink = 0;
        for (int x = 1001; x < map.getWidth(); x++) {
            for (int y = 900; y < map.getHeight(); y++) {
                ink += (map.getRGB(x, y) & 0xff) < 0x80 ? 1 : 0;
            }
        }
        return ink;
    }

    private static int pixel(BufferedImage picture, double x, double y) {
        return picture.getRGB((int) ((x - 2.5 + 150) / 300 * 1000), (int) ((150 + 2.5 - y) / 300 * 1000));
    }
}
