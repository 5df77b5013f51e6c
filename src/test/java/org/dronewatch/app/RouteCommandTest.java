package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.app.Program.Outcome;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The weakest routes before a radar and a receiver, as the command prints and writes them. */
class RouteCommandTest {
    private static final String SENSORS = FieldSite.ROUND
            + "  radio: {kind: rf, position: [0, 5, 4], threshold: 45}\n"
            + "alert: {protect: {centre: [0, 0, 10], radius: 30}, response: 5 s}\n";

    @TempDir
    private static Path directory;

    private static Outcome outcome;
    private static JsonNode json;

    @BeforeAll
    static void run() throws IOException {
        FieldSite.in(directory, SENSORS);
        outcome = route("1", ".");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        json = read("route.json");
    }

    private static JsonNode read(String file) {
        return JsonMapper.builder().build().readTree(directory.resolve(file).toFile());
    }

    private static Outcome route(String threads, String out, String... more) {
        return Program.run(Stream.concat(
                        Stream.of(
                                "route",
                                directory.resolve("site.yaml").toString(),
                                "--heights=10,30m",
                                "--side=500",
                                "--cell=25m",
                                "--threads=" + threads,
                                "--out=" + directory.resolve(out)),
                        Stream.of(more))
                .toArray(String[]::new));
    }

    @Test
    void theFileStatesWhatWasAskedAndWhatWasFound() {
        assertThat(json.propertyNames())
                .containsExactly(
                        "format",
                        "scene",
                        "drone",
                        "pointing",
                        "launch",
                        "response_s",
                        "cell_m",
                        "cells_per_side",
                        "heights_m",
                        "routes",
                        "complete");
        assertThat(json.get("complete").asBoolean()).isTrue();
        assertThat(json.get("response_s").asDouble()).isEqualTo(5.0);
        assertThat(json.get("pointing").asString()).isEqualTo("search");
        assertThat(json.get("routes")).hasSize(8);
        JsonNode first = json.get("routes").get(0);
        assertThat(first.get("sector").asString()).isEqualTo("north");
        assertThat(first.propertyNames())
                .containsExactly(
                        "sector",
                        "points",
                        "exposure",
                        "lower",
                        "upper",
                        "p_detect",
                        "by_sensor",
                        "p_in_time",
                        "critical_s",
                        "p_i",
                        "proof");
        assertThat(first.get("points").get(0).propertyNames()).containsExactly("t", "x", "y", "z", "mode");
        for (JsonNode route : json.get("routes")) {
            double exposure = route.get("exposure").asDouble();
            assertThat(route.get("lower").asDouble())
                    .isLessThanOrEqualTo(route.get("upper").asDouble());
            assertThat(route.get("upper").asDouble()).isLessThanOrEqualTo(exposure + 1e-6);
            assertThat(route.get("p_detect").asDouble()).isCloseTo(1.0 - Math.exp(-exposure), within(1e-5));
            assertThat(route.get("by_sensor").propertyNames()).containsExactly("round", "radio");
            double sum = route.get("by_sensor").get("round").asDouble()
                    + route.get("by_sensor").get("radio").asDouble();
            assertThat(sum).isCloseTo(exposure, within(1e-5));
            JsonNode last = route.get("points").get(route.get("points").size() - 1);
            assertThat(route.get("critical_s").asDouble())
                    .isCloseTo(last.get("t").asDouble() - 5.0, within(1e-5));
            assertThat(Math.hypot(last.get("x").asDouble(), last.get("y").asDouble()))
                    .isLessThanOrEqualTo(30.0);
        }
    }

    @Test
    void theTableHasARowForEachSectorAndTheWeakestInWords() {
        List<String> lines = outcome.out().lines().toList();
        assertThat(lines.get(0))
                .isEqualTo("weakest routes of drone 'one' to the protected zone, by where they begin;"
                        + " exposure counts while 5 s are left for the response:");
        assertThat(lines.subList(2, 10))
                .extracting(line -> line.substring(0, 11).strip())
                .containsExactly(
                        "north", "north-east", "east", "south-east", "south", "south-west", "west", "north-west");
        assertThat(lines.get(11))
                .startsWith("The weakest route comes from the ")
                .endsWith(".");
    }

    /** The drone of a route's scene is where the file states, when it states it, and ends in the zone. */
    @Test
    void aSceneFliesItsRoute() throws IOException {
        Path scene = directory.resolve("route-south-west.yaml");
        Outcome run = Program.run(
                "run", scene.toString(), "--out", directory.resolve("run").toString());
        assertThat(run.code()).as(run.err()).isZero();
        assertThat(run.err()).doesNotContain("warning: drone");
        JsonNode points = json.get("routes").get(5).get("points");
        double end = points.get(points.size() - 1).get("t").asDouble();
        assertThat(read("run/summary.json").get("simulated_s").asDouble()).isCloseTo(end, within(1e-5));
        List<String> legs = Files.readAllLines(directory.resolve("run/flights.csv")).stream()
                .skip(1)
                .toList();
        assertThat(legs).hasSize(points.size());
        for (int i = 0; i < legs.size(); i++) {
            String[] columns = legs.get(i).split(",");
            assertThat(Double.parseDouble(columns[2]))
                    .isCloseTo(points.get(i).get("t").asDouble(), within(1e-5));
            assertThat(Double.parseDouble(columns[3]))
                    .isCloseTo(points.get(i).get("x").asDouble(), within(1e-5));
            assertThat(Double.parseDouble(columns[5]))
                    .isCloseTo(points.get(i).get("z").asDouble(), within(1e-5));
        }
    }

    @Test
    void theFilesHaveTheSameBytesForAnyNumberOfThreads() throws IOException {
        byte[] numbers = Files.readAllBytes(directory.resolve("route.json"));
        byte[] scene = Files.readAllBytes(directory.resolve("route-east.yaml"));
        assertThat(route("3", ".").code()).isZero();
        assertThat(directory.resolve("route.json")).hasBinaryContent(numbers);
        assertThat(directory.resolve("route-east.yaml")).hasBinaryContent(scene);
    }

    /** Flown with many seeds, the radar and the receiver, which do not depend on chance, detect it always or never. */
    @Test
    void aProofIsPrintedAndRepeated() throws IOException {
        Outcome proved = route("2", "proved", "--proof=20");
        assertThat(proved.code()).as(proved.err()).isZero();
        assertThat(proved.out()).contains("flown with many seeds, positioners searching:");
        assertThat(proved.err()).contains("no scenes of the routes are written: world.models.0.file: ");
        for (JsonNode route : read("proved/route.json").get("routes")) {
            JsonNode proof = route.get("proof");
            assertThat(proof.propertyNames()).containsExactly("runs", "k", "low", "high", "predicted", "agrees");
            assertThat(proof.get("runs").asInt()).isEqualTo(20);
            assertThat(route.get("p_i").asDouble())
                    .isBetween(0.0, proof.get("predicted").asDouble());
            assertThat(proof.get("k").asInt())
                    .isEqualTo((int) Math.round(20 * proof.get("predicted").asDouble()));
            assertThat(proof.get("agrees").asBoolean()).isTrue();
        }
        Outcome again =
                Program.run("again", directory.resolve("proved/provenance.json").toString());
        assertThat(again.code()).as(again.out() + again.err()).isZero();
        assertThat(again.out()).contains("same       route.json", "same       routes.png", "same       profile.png");
    }

    /** The pieces of each route follow one another from its start to its end. */
    @Test
    void mapsHaveTheRoutesInPieces() throws IOException {
        Path scene = directory.resolve("on-earth.yaml");
        String origin = "world:\n  origin: {latitude: 50 deg, longitude: 8 deg}\n";
        Files.writeString(
                scene, Files.readString(directory.resolve("site.yaml")).replaceFirst("world:\n", origin));
        Outcome mapped = Program.run(
                "route",
                scene.toString(),
                "--heights=10",
                "--side=400",
                "--cell=40",
                "--out=" + directory.resolve("map"));
        assertThat(mapped.code()).as(mapped.err()).isZero();
        assertThat(directory.resolve("map/routes.kml")).content().contains("<Folder>", "from the south-west");
        JsonNode features = read("map/routes.geojson").get("features");
        String route = "";
        JsonNode before = null;
        int routes = 0;
        for (JsonNode feature : features) {
            JsonNode properties = feature.get("properties");
            JsonNode line = feature.get("geometry").get("coordinates");
            assertThat(line.size()).isGreaterThanOrEqualTo(2);
            if (properties.get("folder").asString().equals(route)) {
                assertThat(line.get(0)).isEqualTo(before);
            } else {
                assertThat(properties.get("begin_s").asDouble()).isZero();
                routes++;
            }
            route = properties.get("folder").asString();
            before = line.get(line.size() - 1);
        }
        assertThat(routes).isEqualTo(8);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--launch={centre: [150, 120], radius: 30}|0",
                "--launch={centre: [0, 65], radius: 3}|2",
                "--launch={centre: [0, 65]}|2",
                "--launch=nowhere|2",
                "--response=-1|2",
                "--response=0|0",
                "--heights=600|2",
                "--cell=300|2",
                "--pointing=up|2",
                "--proof=0|2",
                "--drone=two|2",
                "--set=sensors.round.enabled=false|0",
            })
    void isRefusedInOneLineOrSearched(String option, int code) {
        String name = "option" + option.hashCode();
        Outcome other = Program.run(
                "route",
                directory.resolve("site.yaml").toString(),
                "--side=400",
                option.startsWith("--cell") ? "--seed=1" : "--cell=40",
                option.startsWith("--heights") ? "--seed=2" : "--heights=10",
                option,
                // Pictures take time.
                code == 0 ? "--threads=2" : "--out=" + directory.resolve(name));
        assertThat(other.code()).as(other.err()).isEqualTo(code);
        if (code == 2) {
            assertThat(other.err().lines().filter(line -> !line.startsWith("read ")))
                    .hasSize(1);
            assertThat(directory.resolve(name)).doesNotExist();
        }
    }
}
